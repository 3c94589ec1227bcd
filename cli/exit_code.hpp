#pragma once

// What the program returns, and the exception that stands for "bad usage or input".

#include <stdexcept>
#include <string>
#include <utility>

#include "wend/io/file_error.hpp"

namespace wend::cli {

enum ExitCode : int {
  success = 0,
  no_plan = 1,    // no plan; bench or test-planner found an error; convert --strict found a loss
  bad_input = 2,  // bad usage or input: nothing was planned
  interrupted = 130,  // Ctrl-C, as shells number it
};

/// Ends a subcommand with bad_input. what() is one line for people.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The value of a result. Throws InputError with the message of an error.
template <class T>
T value_or_throw(Expected<T, Error> result) {
  if (!result) throw InputError(result.error().message);
  return *std::move(result);
}

/// Ends a subcommand with no_plan: the path file says why there is no path.
class NoPathError : public std::runtime_error {
 public:
  NoPathError(const std::string& message, FailedPlan plan)
      : std::runtime_error(message), plan_(std::move(plan)) {}

  const FailedPlan& plan() const { return plan_; }

 private:
  FailedPlan plan_;
};

}  // namespace wend::cli
