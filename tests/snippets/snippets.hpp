#pragma once

// What the snippets of the headers call, in the tests that compile and run them.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "wend/robot/free_space.hpp"

namespace wend::test {

/// What report() was told last.
inline std::string reported;
inline void report(std::string_view what) { reported = what; }

/// 10 x 8 free cells.
inline const FreeSpace& open_ground() {
  static const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(10, 8, CellState::free)));
  return space;
}

/// A map file in a folder of its own, which is the working folder while this lives.
class OfficeInWorkingFolder {
 public:
  OfficeInWorkingFolder() {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "office.yaml")
        << "image: office.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\n"
           "occupied_thresh: 0.65\nfree_thresh: 0.25\n";
    std::ofstream(folder_ / "office.pgm") << "P2 4 3 255\n"
                                             "254 254 254 254\n254 0 0 254\n254 254 254 254\n";
    std::filesystem::current_path(folder_);
  }
  ~OfficeInWorkingFolder() {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
  }
  OfficeInWorkingFolder(const OfficeInWorkingFolder&) = delete;
  OfficeInWorkingFolder& operator=(const OfficeInWorkingFolder&) = delete;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("wend_snippets_" + std::to_string(getpid()));
};

}  // namespace wend::test
