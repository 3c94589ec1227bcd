#pragma once

// Error: why wend could not do what was asked: the kind of problem, a sentence for people, and the part
// of the input that is wrong. It is the error type of all functions that return an Expected.
//
//   const auto footprint = wend::parse_footprint(text);
//   if (!footprint) return report(footprint.error().message);

#include <string>
#include <utility>

#include "wend/base/expected.hpp"
#include "wend/base/status.hpp"

namespace wend {

struct Error {
  Status status = Status::invalid_option;  // the kind of problem; never found
  std::string message;  // complete, without a full stop: "office.map:7: row 3 has 2 columns, ..."
  std::string where = {};  // what is wrong: "office.map:7", "corner 3", an option's name; or empty

  friend bool operator==(const Error&, const Error&) = default;
};

/// For `return`, from every function that returns an Expected<..., Error>.
inline Unexpected<Error> failure(Status status, std::string message, std::string where = {}) {
  return Unexpected<Error>(Error{status, std::move(message), std::move(where)});
}

}  // namespace wend
