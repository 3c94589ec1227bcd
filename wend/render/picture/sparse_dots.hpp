#pragma once

// Dots for a scene's sparse_cells(), in their roles' colours.

#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// With a rim.
void draw_sparse_cells(cairo_t* context, const Scene& scene, const MapView& view,
                       const Style& style);

/// In half blocks: a pixel each.
void draw_sparse_pixels(cairo_t* context, const Scene& scene, const MapView& view,
                        const Style& style);

}  // namespace wend
