#pragma once

// The cells of a map as an image of any size: one algorithm for enlarging and for shrinking. Every
// pixel is the weighted mean of the cells under it by the area they share, so enlarging by a whole
// number gives crisp squares.

#include <cstdint>

#include "wend/map/grid.hpp"
#include "wend/render/picture/cell_paints.hpp"

namespace wend {

/// Pixels as 0xRRGGBB, drawn as the source file looks. O(cells + pixels), in the memory of the
/// image and one more row.
Grid<std::uint32_t> map_image(const CellPaints& paints, int width, int height, bool y_up);

}  // namespace wend
