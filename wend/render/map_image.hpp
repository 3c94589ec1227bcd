#pragma once

// The cells of a map as an image of any size: one algorithm for enlarging and for shrinking. Every
// pixel is the weighted mean of the cells under it by the area they share, so enlarging by a whole
// number gives crisp squares.

#include "wend/render/cairo_objects.hpp"
#include "wend/render/cell_paints.hpp"

namespace wend {

/// An RGB24 image, drawn as the source file looks; check its cairo status. O(cells + pixels), one
/// row of pixels more than the image in memory.
CairoSurface map_image(const CellPaints& paints, int width, int height, bool y_up);

}  // namespace wend
