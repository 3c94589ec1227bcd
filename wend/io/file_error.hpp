#pragma once

// Errors of files: what is wrong, with the file and the line in front. Error::where is "office.map:7",
// or "office.map" if no line applies.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "wend/base/error.hpp"

namespace wend {

/// The error of a file: "office.map:7: row 3 has 2 columns, the header says 5". Lines start at 1; at 0
/// no line applies.
inline Error file_error(std::string file, std::size_t line, const std::string& what) {
  if (line > 0) file.append(":").append(std::to_string(line));
  std::string message = file + ": " + what;
  return {Status::invalid_file, std::move(message), std::move(file)};
}

/// For `return`, from every function that returns an Expected<..., Error>.
inline Unexpected<Error> file_failure(std::string file, std::size_t line, const std::string& what) {
  return Unexpected<Error>(file_error(std::move(file), line, what));
}

/// The content of a path file for a query without a path.
struct FailedPlan {
  std::string status;  // a name of the enum Status, or "not_free" for a path that collides
  std::string reason;  // one line for people

  friend bool operator==(const FailedPlan&, const FailedPlan&) = default;
};

/// Why a path file gives no path.
struct PathFileError : Error {
  std::optional<FailedPlan> failed_plan;  // set if the file is valid and says why there is no path

  /// The error of a file, and the failed plan that it reports, if any.
  // NOLINTNEXTLINE(google-explicit-constructor): every error of a file is one of a path file
  PathFileError(Error error, std::optional<FailedPlan> plan = {})
      : Error(std::move(error)), failed_plan(std::move(plan)) {}
};

/// For a file that says why there is no path.
inline Unexpected<PathFileError> no_path_failure(std::string file, FailedPlan plan) {
  std::string what = "no path: " + plan.reason;
  if (plan.reason.empty()) what = "no path: the plan's status is '" + plan.status + "'";
  Error error = file_error(std::move(file), 0, what);
  if (const auto status = status_from_string(plan.status)) error.status = *status;
  return Unexpected<PathFileError>(PathFileError(std::move(error), std::move(plan)));
}

}  // namespace wend
