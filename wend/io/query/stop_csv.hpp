#pragma once

// Stops as CSV: a place in every row, written as --start of `wend plan` takes it: metres in the map's frame, or cells.
// Pairs of stops as CSV: two rows of such a file, counted from 0, of which the first must be visited before the second.
//
//   x,y,heading     x,y      first,second
//   1,1,E           1,1      0,3
//   15,9,any        15,9     2,1
//
// The header names the columns, in any order; others are ignored. The separator is ';' if the header has one. Lines
// end with LF or CRLF; blank lines are skipped.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/io/file_error.hpp"

namespace wend {

inline constexpr std::size_t kLargestStopFile = std::size_t{16} << 20;  // bytes

/// "1,1" or "1,1,E" for each row. `file` is the name for errors, which name the line.
WEND_API Expected<std::vector<std::string>, Error> parse_stop_csv(std::string_view text,
                                                                  const std::string& file);
/// The rows of a file of pairs.
WEND_API Expected<std::vector<std::pair<int, int>>, Error> parse_stop_pair_csv(
    std::string_view text, const std::string& file);

/// The same from files. Fail with invalid_file if a file cannot be read or is invalid.
WEND_API Expected<std::vector<std::string>, Error> load_stop_csv(const std::filesystem::path& file);
/// The same of pairs.
WEND_API Expected<std::vector<std::pair<int, int>>, Error> load_stop_pair_csv(
    const std::filesystem::path& file);

}  // namespace wend
