#pragma once

// Helpers that the tests of this folder share.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "wend/io/file_error.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// A folder that exists for one test.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(std::filesystem::path(testing::TempDir()) / name()) {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(std::string_view file) const { return path_ / file; }

  std::filesystem::path write(std::string_view file, std::string_view bytes) const {
    std::ofstream(path_ / file, std::ios::binary) << bytes;
    return path_ / file;
  }

 private:
  static std::string name() {
    static int count = 0;
    return "wend_io_test_" + std::to_string(getpid()) + "_" + std::to_string(count++);
  }

  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The cells, row 0 first: '.' free, '#' occupied, '?' unknown.
inline std::string cells_of(const GridMap& map) {
  std::string text;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const CellState state = map.state({x, y});
      text += state == CellState::free ? '.' : state == CellState::occupied ? '#' : '?';
    }
    text += '\n';
  }
  return text;
}

inline bool same_map(const GridMap& a, const GridMap& b) {
  return a.occupied() == b.occupied() && a.unknown() == b.unknown() && a.terrain() == b.terrain() &&
         a.frame() == b.frame();
}

/// "file:line: what" of a result that should be an error, "no error" if it is not.
template <class T, class E>
std::string error_of(const Expected<T, E>& result) {
  return result ? "no error" : result.error().message;
}

/// The map in a text of this format, under the name "m".
inline Expected<LoadedMap, Error> load_as(MapFormat format, std::string_view text) {
  return info_of(format).load(std::string(text), {"m"});
}

}  // namespace wend
