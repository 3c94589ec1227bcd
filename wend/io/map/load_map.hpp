#pragma once

// Loading maps: one function for every format.
//
//   format        names                     y     units
//   ROS map       *.yaml *.yml (+ image)    up    metres
//   MovingAI      *.map                     down  cells
//   text grid     *.txt *.grid              down  cells
//   bare image    *.png *.pgm *.pbm *.ppm   down  cells, or metres where a resolution is given
//                 *.bmp *.jpg *.jpeg
//
// The name decides. For other names, the beginning of the file tells the format: a text grid has only
// letters of cells in its first line. Every loader returns a map, or an error with the file, the line and
// the reason. Memory is proportional to the size of the file.
//
//   const auto loaded = wend::load_map("office.yaml");
//   if (!loaded) return report(loaded.error().message);
//   plan_on(loaded->map);

#include <filesystem>
#include <string>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/map/map_format.hpp"

namespace wend {

/// Loads a map. Fails with invalid_file if the file cannot be read or its content is invalid, or if
/// the map is too large.
WEND_API Expected<LoadedMap, Error> load_map(const std::filesystem::path& file,
                                             const LoadOptions& options = {});

/// The same from bytes in memory. `name` is the name for errors; its extension, if any, decides the
/// format. The image of a map.yaml is searched for in the working folder.
WEND_API Expected<LoadedMap, Error> parse_map(const std::string& bytes, const std::string& name,
                                              const LoadOptions& options = {});

}  // namespace wend
