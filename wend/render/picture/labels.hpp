#pragma once

// Labels: text in pictures, in the font that the system calls "sans-serif".

#include <string>
#include <string_view>

#include "wend/geometry/pose.hpp"
#include "wend/render/picture/cairo_objects.hpp"

namespace wend {

void select_label_font(cairo_t* context, double size);

/// In the font that is selected, pixels.
double text_width(cairo_t* context, std::string_view text);

/// From the left end of its baseline.
void draw_text(cairo_t* context, Point baseline, std::string_view text, const Colour& colour);

/// The text, or as much of its beginning as fits into that many pixels with an ellipsis.
std::string shortened(cairo_t* context, std::string_view text, double room);

}  // namespace wend
