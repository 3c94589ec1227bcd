#pragma once

// What a map format cannot hold of a map.
//
//   format        cells               terrain                            frame
//   ROS map.yaml  all three states    free cells: 1 + 4 v/100, v to 100  resolution, y up, and an
//                                                                        origin if y was up before
//   text grid     all three states    free cells: whole numbers up to 9  none
//   image         all three states    none                               none
//   MovingAI      free and occupied   none                               none
//
// Without a frame, cells are the unit and y points down. Maps are written as they are drawn, so where y
// turns round, row 0 is another row. Each format says in its MapFormatInfo what it holds.

#include <string>
#include <vector>

#include "wend/io/map/map_format.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// The nearest map that the format can hold: save_map() takes it, and load_map() then gives exactly
/// this map back. Unknown cells become occupied where there are none, terrain is rounded to the
/// nearest that there is. O(n) in time and memory.
GridMap nearest_map(const GridMap& map, MapFormat format);

/// What is different in nearest_map(), a sentence for people each: how many cells it is about, what
/// becomes of them and why. Empty if and only if the format holds the whole map. O(n).
std::vector<std::string> losses(const GridMap& map, MapFormat format);

/// Why save_map() refuses a map: the first of its cells that the format cannot hold, and which formats can.
/// Empty if it holds them all; the frame and the terrain of occupied cells do not count.
std::string cells_not_held(const GridMap& map, MapFormat format);

}  // namespace wend
