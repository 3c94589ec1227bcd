#pragma once

// Where the image of a map.yaml is. The file may come from another computer, so these places are tried:
//
//   1. the path as it is written, seen from the yaml's folder; `~/` begins the home folder
//   2. the same with `/` for `\\`, as Windows writes paths
//   3. its last part, beside the yaml

#include <filesystem>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/map/map_format.hpp"

namespace wend {

/// The image of a map.yaml.
struct ImageFile {
  std::filesystem::path file;  // as it can be opened
  std::string note;            // if it is not where the yaml says: where it is; else empty
};

/// Finds the image that a map.yaml names. Fails with invalid_file, and names every place where it is not.
Expected<ImageFile, Error> find_image(const std::string& name, const MapSource& source);

}  // namespace wend
