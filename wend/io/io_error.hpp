#pragma once

// IoError: what is wrong with a file, and where.

#include <cstddef>
#include <string>
#include <utility>

#include "wend/base/expected.hpp"

namespace wend {

struct IoError {
  std::string file;
  std::size_t line = 0;  // from 1; 0 where a line makes no sense
  std::string what;      // "row 3 has 2 columns, the header says 5"

  /// "office.map:7: row 3 has 2 columns, the header says 5"
  std::string message() const {
    std::string message = file;
    if (line > 0) message.append(":").append(std::to_string(line));
    return message.append(": ").append(what);
  }
};

/// For `return`, from every function that returns an Expected<..., IoError>.
inline Unexpected<IoError> io_failure(std::string file, std::size_t line, std::string what) {
  return Unexpected<IoError>(IoError{std::move(file), line, std::move(what)});
}

}  // namespace wend
