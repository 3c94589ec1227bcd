#pragma once

// The path of a car in a picture: every arc as it is, solid where the car drives ahead and dashed
// where it drives in reverse, and small arrows at the poses, along their headings. Where poses lie
// close to each other only some of them have an arrow.

#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/picture/marks.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// Without a halo (where a pixel is as large as half a character) only the lines are drawn, and
/// colours alone tell the two ways to drive apart.
void draw_driven_path(cairo_t* context, const Scene& scene, const MapView& view,
                      const MarkSizes& sizes, const Style& style);

/// A piece of such a path as legends show it, that long.
void draw_driven_sample(cairo_t* context, Point centre, double length, bool reverse,
                        const Style& style);

}  // namespace wend
