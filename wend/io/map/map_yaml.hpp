#pragma once

// ROS `map.yaml` files: an image, and how to read it as a map.
//
//   key              value                                                        without it
//   image            path of a PNG, PNM, BMP or JPEG file, seen from the yaml's   error
//                    folder (image_file.hpp: where else it is looked for)
//   resolution       metres a cell, > 0                                           error
//   origin           [x, y, yaw] of the lower-left corner of the lower-left       error
//                    cell: metres, and radians counter-clockwise
//   negate           0, 1, false, true: whether white is occupied                 error
//   occupied_thresh  occupancies from here on are occupied, in 0..1               error
//   free_thresh      occupancies up to here are free, in 0..1, below the other    error
//   mode             trinary, scale, raw (image_map.hpp says what they mean)      trinary
//
// Where ROS 1 and Nav2 differ, wend reads a file like Nav2. Other keys get a note. The grid has y up:
// row 0 is the image's bottom row.
//
// Nothing in the file is run, fetched or expanded: aliases that name a value are followed, a
// document is at most 64 KiB, unknown tags and duplicate keys are errors.

#include <filesystem>
#include <string>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/map/image_map.hpp"
#include "wend/io/map/map_format.hpp"

namespace wend {

/// The content of a map.yaml.
struct MapYaml {
  std::filesystem::path image;  // as written in the file
  Frame frame;
  ImageMeaning meaning;
  std::vector<std::string> notes = {};
};

/// `file` is the name for errors.
Expected<MapYaml, Error> parse_map_yaml(const std::string& text, const std::string& file);

/// The map that a text describes. Also reads its image, from where find_image() finds it. An error about the image
/// names both files.
Expected<LoadedMap, Error> load_map_yaml(const std::string& text, const MapSource& source,
                                         const LoadOptions& options = {});

/// The text of a map.yaml.
std::string format_map_yaml(const MapYaml& yaml);

}  // namespace wend
