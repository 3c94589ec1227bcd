#pragma once

// Loading paths: the CSV of path_csv.hpp; the JSON of a plan, whose "path" is a list of cells
// [[x,y],...], or of points, with "headings" beside it, one for each, and whose "path_smoothed" are
// waypoints in grid coordinates; or centrelines in metres. A name that ends in .csv or .json decides;
// else JSON begins with '{'.
//
// A centreline is a CSV whose header names columns x_m and y_m, in the map's frame:
//
//   # x_m, y_m, w_tr_right_m, w_tr_left_m
//   0.0, 0.0, 1.1, 1.1
//
// The header is the last of the leading comments (#), or the first other line; the separator is ',' or
// ';', and blanks do not matter. The points become waypoints.
//
// Strict: a CSV has one of these headers and as many columns in every line; JSON has an object with a
// list of cells or points. Coordinates of cells lie in -2^30..2^30-1, those of points in -2^30..2^30. Whether
// they lie on a map, and whether they are neighbours, is not checked. A heading is N, W, E or S as drawn, or a
// number of radians in -1e6..1e6; the frame of the path's map says whether north is up or down in its grid. A file
// without a point is an error; for a failed plan the error's failed_plan has the status and the reason
// why there is no path. Other columns must be numbers and are ignored, and so are other keys of the plan.
// Memory is proportional to the size of the file, which may have 256 MiB.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/io/file_error.hpp"
#include "wend/path/path.hpp"

namespace wend {

inline constexpr std::size_t kLargestPathFile = std::size_t{256} << 20;  // bytes

/// Which path of a plan to load: as planned, or as smoothed. If a plan has only one, that one is loaded.
enum class PathStage {
  planned,  // as the planner found it
  smoothed  // as it was smoothed
};

/// Loads a path in grid coordinates of a map with this frame. Fails with invalid_file, or with the
/// status of the failed plan that the file reports.
WEND_API Expected<Path, PathFileError> load_path(const std::filesystem::path& file,
                                                 const Frame& frame,
                                                 PathStage stage = PathStage::planned);

/// The same from a text, which is JSON if it begins with '{'. `name` is the name for errors.
WEND_API Expected<Path, PathFileError> parse_path(std::string_view text, const std::string& name,
                                                  const Frame& frame,
                                                  PathStage stage = PathStage::planned);

/// The same for a CSV of cells, poses, waypoints or a centreline. `file` is the name for errors.
WEND_API Expected<Path, PathFileError> parse_path_csv(std::string_view text,
                                                      const std::string& file, const Frame& frame);
/// The same for the JSON of a plan.
WEND_API Expected<Path, PathFileError> parse_path_json(std::string_view text,
                                                       const std::string& file, const Frame& frame,
                                                       PathStage stage = PathStage::planned);

}  // namespace wend
