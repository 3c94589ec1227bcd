#pragma once

// Loading maps: one function for every format.
//
//   format        names                     y     units
//   ROS map       *.yaml *.yml (+ image)    up    metres
//   MovingAI      *.map                     down  cells
//   text grid     *.txt *.grid              down  cells
//   bare image    *.png *.pgm *.pbm *.ppm   down  cells, or metres where a resolution is given
//
// The name decides. The format of a file with another name is recognised by how the file begins: a text
// grid by a first line with only letters of cells. Every loader returns a map, or an error with file, line
// and what is wrong. Memory stays in proportion to the file.
//
//   const auto loaded = wend::load_map("office.yaml");
//   if (!loaded) return report(loaded.error().message());
//   plan_on(loaded->map);

#include <filesystem>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"
#include "wend/io/map/map_format.hpp"

namespace wend {

Expected<LoadedMap, IoError> load_map(const std::filesystem::path& file,
                                      const LoadOptions& options = {});

/// The same from bytes that came from elsewhere. `name` is the name for errors; its extension, if it has
/// one, decides. The image of a map.yaml is looked for in the working folder.
Expected<LoadedMap, IoError> parse_map(const std::string& bytes, const std::string& name,
                                       const LoadOptions& options = {});

}  // namespace wend
