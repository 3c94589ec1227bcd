#pragma once

// Saving maps in the format given by the file's name:
//
//   .map               MovingAI: free and occupied cells, nothing else
//   .txt .grid         text grid: also unknown cells, and whole multipliers from 1 to 9
//   .png .pgm .pnm     picture: 0 occupied, 254 free, 205 unknown, as map savers write it
//   .yaml .yml         ROS map: X.yaml and, beside it, its picture X.png. Terrain goes into a
//                      `mode: scale` map if its multipliers are 1 + 4 v/100 for whole v up to 100
//
// Cells and terrain that a format cannot hold are an error, and nothing is written: they are never changed
// silently. nearest_map() of losses.hpp changes them so that they fit, and losses() lists the changes.
// Only .yaml keeps the frame. Pictures and texts show the map as it is drawn; loading them gives the same
// cells in the same order, upside down only if y up becomes y down or the other way round. A yaml from
// a map with y down has the origin (0, 0, 0).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// Each file is replaced completely or left unchanged.
WEND_API Expected<void, Error> save_map(const GridMap& map, const std::filesystem::path& file);

/// The bytes that save_map() writes. `file` is their name: images differ by extension, and a map.yaml
/// names its image. What the format cannot hold is unsupported_map, with the format's name as Error::where.
WEND_API Expected<MapFiles, Error> encode_map(const GridMap& map, MapFormat format,
                                              const std::filesystem::path& file = {});

/// The format that a file of this name is saved in; an error lists the extensions.
WEND_API Expected<MapFormat, Error> saved_format(const std::filesystem::path& file);

/// The picture that saving a map.yaml of this name would replace although it belongs to another map: it
/// exists, and no map.yaml of this name refers to it. Nothing if no such file is lost.
WEND_API std::optional<std::filesystem::path> unrelated_picture(const std::filesystem::path& file);

/// Every file that save_map() writes for this name: a map.yaml has its picture beside it.
WEND_API std::vector<std::filesystem::path> saved_files(const std::filesystem::path& file);

}  // namespace wend
