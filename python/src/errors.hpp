#pragma once

// Errors of wend as Python exceptions: throw_failure() throws what a function bound to Python lets pass;
// wend._errors.make_error() then chooses the class.

#include <nanobind/nanobind.h>

#include <exception>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "wend/base/error.hpp"
#include "wend/planner/failure.hpp"

namespace wend::python {

/// An Error on its way to Python. With the work of a search, it becomes wend.NoPath.
struct Failed : std::exception {
  explicit Failed(Error what) : error(std::move(what)) {}
  explicit Failed(PlanFailure what) : error(what), work(what.metrics) {}

  const char* what() const noexcept override { return error.message.c_str(); }

  Error error;
  std::optional<SearchMetrics> work = {};
};

[[noreturn]] inline void throw_failure(Status status, std::string message, std::string where) {
  throw Failed(Error{status, std::move(message), std::move(where)});
}

/// The value of an Expected; throws its error.
template <class T, class E>
T value_or_throw(Expected<T, E> result) {
  if (!result) throw Failed(std::move(result.error()));
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

/// The exception that Python gets, as an object. `unread` is a Reason, or None. Needs the interpreter lock.
nanobind::object exception_of(const Failed& failed,
                              const nanobind::object& unread = nanobind::none());

/// Makes Python raise an exception. Needs the interpreter lock.
[[noreturn]] void raise(const nanobind::object& exception);

/// Makes nanobind translate Failed.
void translate_errors();

}  // namespace wend::python
