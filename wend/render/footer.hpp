#pragma once

// The footer of a picture: a scale bar on the left, and on the right what the marks and colours
// mean (only of those that occur).

#include "wend/render/cairo_objects.hpp"
#include "wend/render/picture_layout.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

struct ScaleBar {
  double length = 1;  // metres, or cells
  double pixels = 1;
  std::string label;  // "5 m", "10 cells"
};

/// The longest bar of 1, 2 or 5 times a power of ten that is not longer than `most` pixels; in
/// whole cells unless the map has metres.
ScaleBar scale_bar(const Frame& frame, double pixels_a_cell, double most);

void draw_footer(cairo_t* context, const Scene& scene, const PictureLayout& layout,
                 const Style& style);

}  // namespace wend
