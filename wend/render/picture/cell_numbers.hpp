#pragma once

// The values of a heatmap, written into cells that are large enough for them.

#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// Are the cells large enough for the numbers of the scene's heatmap, if it has one?
bool shows_cell_numbers(cairo_t* context, const Scene& scene, const MapView& view);

/// Nothing where the longest number does not fit into a cell. Cells without a finite value, and
/// obstacles, stay empty. With arrows or a path of cells the numbers lie below the middle
/// of the cell.
void draw_cell_numbers(cairo_t* context, const Scene& scene, const MapView& view,
                       const Style& style);

}  // namespace wend
