#pragma once

// Loading paths that wend wrote: the CSV of path_csv.hpp, or the JSON of a plan, whose "path" is a
// list of cells [[x,y],...], or of points, with "headings" beside it, one for each. A name that ends
// in .csv or .json decides; else JSON begins with '{'.
//
// Strict: a CSV has one of the two headers and as many columns in every line, JSON has an object
// with a list of cells or points. Cells lie in 0..2^30-1, as those of every map do, points in
// 0..2^30; whether a map has them, and whether they are neighbours, is not checked. A heading is N,
// W, E or S as drawn, or a number of radians; the frame of the path's map says whether north is up
// or down in its grid. A file without a cell or pose is an error, for a plan that failed one that
// says why there is no path. Columns in metres and other keys of the plan are not used. Memory stays
// in proportion to the file, which may have 256 MiB.

#include <filesystem>
#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/io/io_error.hpp"
#include "wend/path/path.hpp"

namespace wend {

Expected<Path, IoError> load_path(const std::filesystem::path& file, const Frame& frame);

/// The same from a text. `file` is the name for errors.
Expected<Path, IoError> parse_path_csv(std::string_view text, const std::string& file,
                                       const Frame& frame);
Expected<Path, IoError> parse_path_json(std::string_view text, const std::string& file,
                                        const Frame& frame);

}  // namespace wend
