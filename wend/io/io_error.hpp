#pragma once

// IoError: what is wrong with a file, and where.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "wend/base/expected.hpp"

namespace wend {

/// The content of a path file for a query without a path.
struct FailedPlan {
  std::string status;  // a name of the enum Status, or "not_free" for a path that collides
  std::string reason;  // one line for people

  friend bool operator==(const FailedPlan&, const FailedPlan&) = default;
};

struct IoError {
  std::string file;
  std::size_t line = 0;                        // from 1; 0 if no line applies
  std::string what;                            // "row 3 has 2 columns, the header says 5"
  std::optional<FailedPlan> failed_plan = {};  // set if the file is valid but has no path

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

/// The same for a file that says why there is no path.
inline Unexpected<IoError> no_path_failure(std::string file, FailedPlan plan) {
  std::string what = "no path: " + plan.reason;
  if (plan.reason.empty()) what = "no path: the plan's status is '" + plan.status + "'";
  return Unexpected<IoError>(IoError{std::move(file), 0, std::move(what), std::move(plan)});
}

}  // namespace wend
