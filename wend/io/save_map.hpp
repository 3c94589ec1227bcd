#pragma once

// Saving maps, in the format that the file's name asks for:
//
//   .map               MovingAI: free and occupied cells, nothing else
//   .txt .grid         text grid: also unknown cells, and whole multipliers from 1 to 9
//   .png .pgm          picture: 0 occupied, 254 free, 205 unknown, as map savers write it
//   .yaml .yml         ROS map: X.yaml and, beside it, its picture X.png. Terrain goes into a
//                      `mode: scale` map if its multipliers are 1 + 4 v/100 for whole v up to 100
//
// What a format cannot hold is an error that says so, and nothing is written: cells are never
// changed quietly. The frame is kept by .yaml only. Pictures and texts come out as the map is
// drawn; loading them back gives the same cells in the same order, upside down only where y up
// becomes y down or the other way round. A yaml from a map with y down has the origin (0, 0, 0).

#include <filesystem>

#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// Each file is replaced whole or left alone.
Expected<void, IoError> save_map(const GridMap& map, const std::filesystem::path& file);

}  // namespace wend
