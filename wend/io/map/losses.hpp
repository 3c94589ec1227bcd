#pragma once

// The parts of a map that a format cannot hold.
//
//   format        cells               terrain                            frame
//   ROS map.yaml  all three states    free cells: 1 + 4 v/100, v to 100  resolution, y up, and an
//                                                                        origin if y was up before
//   text grid     all three states    free cells: whole numbers up to 9  none
//   image         all three states    none                               none
//   MovingAI      free and occupied   none                               none
//
// Without a frame, cells are the unit and y points down. Maps are written as they are drawn, so if the
// direction of y changes, row 0 is another row. The MapFormatInfo of a format says what it holds.

#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// The nearest map that the format can hold: save_map() accepts it, and load_map() then returns exactly
/// this map. If the format has no unknown cells, they become occupied; terrain is rounded to the nearest
/// value of the format. O(n) in time and memory.
WEND_API GridMap nearest_map(const GridMap& map, MapFormat format);

/// The differences in nearest_map(), one sentence for users each: how many cells change, how they change
/// and why. Empty if and only if the format holds the whole map. O(n).
WEND_API std::vector<std::string> losses(const GridMap& map, MapFormat format);

/// Why save_map() rejects a map: the first cell that the format cannot hold, and which formats can.
/// Empty if it holds all cells; the frame and the terrain of occupied cells do not count.
WEND_API std::string cells_not_held(const GridMap& map, MapFormat format);

}  // namespace wend
