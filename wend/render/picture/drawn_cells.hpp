#pragma once

// The cells of a map as an image of any size, as rectangles, and those that need a dot to be seen.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "wend/map/grid.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// Pixels as 0xRRGGBB, drawn as the source file looks. Every pixel is the weighted mean of the cells
/// under it by the area they share: enlarging by a whole number gives crisp squares, and shrinking
/// takes the same steps. O(cells + pixels), in the memory of the image and one more row.
Grid<std::uint32_t> map_image(const CellPaints& paints, int width, int height, bool y_up);

/// The same in few pixels, at most as many as cells each way: every pixel has the colour of most of its cells, so that
/// none is a mixture, and is an obstacle if a wall crosses it. O(cells).
Grid<std::uint32_t> dominant_image(const CellPaints& paints, int width, int height, bool y_up);

struct MapRectangle {
  Colour colour;
  int x = 0;  // cells
  int y = 0;
  int width = 0;
  int height = 0;

  friend constexpr bool operator==(const MapRectangle&, const MapRectangle&) = default;
};

/// For vector formats: rectangles of all cells that are not of the colour `background`. Cells of one
/// colour in a row become one, and so do equal ones in rows that follow each other; those of one
/// colour come together. Nothing if there are more than `most`. O(cells).
std::optional<std::vector<MapRectangle>> map_rectangles(const CellPaints& paints,
                                                        const Colour& background, std::size_t most);

/// The expanded cells without expanded neighbours, on a map so large that they would vanish where
/// many cells share a pixel: what a planner that jumps expands. None if cells are at least as large
/// as dots, or if the dots would hide the map. Sizes in pixels. O(cells).
std::vector<Cell> sparse_cells(const MarkedCells& marked, double pixels_a_cell, double dot);

}  // namespace wend
