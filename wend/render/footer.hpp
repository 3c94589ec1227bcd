#pragma once

// The footer of a picture: a scale bar on the left, and on the right what the marks and colours
// mean (only of those that occur).

#include "wend/render/cairo_objects.hpp"
#include "wend/render/picture_layout.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

void draw_footer(cairo_t* context, const Scene& scene, const PictureLayout& layout,
                 const Style& style);

}  // namespace wend
