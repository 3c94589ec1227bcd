#pragma once

// Error: why user input is invalid. It holds the kind of problem, a sentence that says what is wrong
// and what would be right, and the part of the input that is wrong.
//
//   const auto footprint = wend::parse_footprint(text);
//   if (!footprint) return report(footprint.error().message);

#include <string>
#include <utility>

#include "wend/base/expected.hpp"
#include "wend/base/status.hpp"

namespace wend {

struct Error {
  Status status = Status::invalid_option;
  std::string message;     // a sentence without a full stop
  std::string where = {};  // the name of the wrong part ("corner 3"), or empty
};

/// For `return`, from every function that returns an Expected<..., Error>.
inline Unexpected<Error> failure(Status status, std::string message, std::string where = {}) {
  return Unexpected<Error>(Error{status, std::move(message), std::move(where)});
}

}  // namespace wend
