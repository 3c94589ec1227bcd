#pragma once

// Queries as CSV: a start and a goal in every row, written as --start and --goal of `wend plan` take
// them: metres in the map's frame, or cells. The header names the columns, in any order:
//
//   start_x,start_y,goal_x,goal_y        start,goal
//   1,1,15,9                             "1,1","15,9"
//   2.5,1,3,8.25                         "2.5,1","3,8.25"
//
// A car also has start_heading and goal_heading, or a third part of start and goal: "1,1,E". Other
// columns are ignored. The separator is ';' if the header has one; blanks around a field are ignored.
// A field that contains a separator is in double quotes, and a quote in it is doubled (RFC 4180); a
// row is one line. Lines end with LF or CRLF; blank lines are skipped.
//
// A row that cannot be read is kept with its error: the others can still be answered.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/io/file_error.hpp"

namespace wend {

/// One row: a query as text, or the error in it.
struct QueryRow {
  std::size_t line = 0;  // in the file, from 1
  std::string start;     // "1,1"; for a car "1,1,E"
  std::string goal;      // the same
  std::string wrong;     // the error in this row; empty if the row is valid

  friend bool operator==(const QueryRow&, const QueryRow&) = default;
};

inline constexpr std::size_t kLargestQueryFile = std::size_t{256} << 20;  // bytes

/// `file` is the name for errors. Memory is proportional to the text.
WEND_API Expected<std::vector<QueryRow>, Error> parse_query_csv(std::string_view text,
                                                                const std::string& file);

/// The same from a file. Fails with invalid_file if the file cannot be read or its header is
/// invalid.
WEND_API Expected<std::vector<QueryRow>, Error> load_query_csv(const std::filesystem::path& file);

}  // namespace wend
