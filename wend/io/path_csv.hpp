#pragma once

// Paths as CSV, for spreadsheets and plotting programs:
//
//   x,y,x_m,y_m
//   1,1,0.075,0.075
//   2,1,0.125,0.075
//
// One line a cell, start and goal included: column and row, then the cell's centre in the map's
// frame, in metres (cells, for a map without a resolution). Numbers read back exactly;
// load_path() reads the cells.

#include <filesystem>
#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/io/io_error.hpp"
#include "wend/path/path.hpp"

namespace wend {

inline constexpr std::string_view kPathCsvHeader = "x,y,x_m,y_m";

std::string path_csv(const Path& path, const Frame& frame);

Expected<void, IoError> save_path_csv(const Path& path, const Frame& frame,
                                      const std::filesystem::path& file);

}  // namespace wend
