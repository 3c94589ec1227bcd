#pragma once

// What every function of the C interface does at its border: it turns errors into a status and a sentence,
// stops exceptions, and checks the structures and pointers of the caller.

#include <cstddef>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "wend/base/error.hpp"
#include "wend/planner/failure.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/wend.h"

namespace wend::c {

/// Why a function of the C interface fails.
struct Failure {
  wend_status status;
  std::string message;
  SearchMetrics metrics = {};
};

wend_status status_of(Status status);

inline Failure failure_of(Error error) {
  return {status_of(error.status), std::move(error.message)};
}
inline Failure failure_of(PlanFailure failure) {
  return {status_of(failure.status), std::move(failure.message), failure.metrics};
}

/// For `return`: a library function failed.
template <class AnyError>
Unexpected<Failure> failed(AnyError error) {
  return Unexpected<Failure>(failure_of(std::move(error)));
}

/// For `return`: the caller's argument is wrong.
inline Unexpected<Failure> refused(std::string message) {
  return Unexpected<Failure>({WEND_INVALID_ARGUMENT, std::move(message)});
}

/// Writes an error, if the caller wants it, and returns its status. Takes no memory.
wend_status report(wend_status status, const char* message, const SearchMetrics& metrics,
                   wend_error* error) noexcept;

/// The same. Messages repeat what a caller wrote, whatever its bytes: they become a line of UTF-8.
wend_status report(const Failure& failure, wend_error* error);

/// Reports the exception that is being handled.
wend_status report_exception(wend_error* error) noexcept;

/// Runs work(), which returns Expected<void, Failure>, and reports how it ended.
template <class Work>
wend_status guarded(wend_error* error, Work&& work) noexcept {
  try {
    const Expected<void, Failure> outcome = work();
    if (outcome) return report(WEND_OK, "", {}, error);
    return report(outcome.error(), error);
  } catch (...) {
    return report_exception(error);
  }
}

/// Runs make(), which returns Expected<std::unique_ptr<Object>, Failure>, and gives the object to the caller.
template <class Object, class Make>
wend_status made(const char* name, Object** object, wend_error* error, Make&& make) noexcept {
  if (object != nullptr) *object = nullptr;
  return guarded(error, [&]() -> Expected<void, Failure> {
    if (object == nullptr) return refused(std::string(name) + " is null");
    Expected<std::unique_ptr<Object>, Failure> result = make();
    if (!result) return Unexpected<Failure>(std::move(result.error()));
    *object = result->release();
    return {};
  });
}

/// The structure of the caller, or the defaults for null.
template <class Options>
Expected<Options, Failure> options_of(const char* name, const Options* options,
                                      const Options& defaults) {
  if (options == nullptr) return defaults;
  if (options->struct_size != sizeof(Options)) {
    return refused(std::string(name) + ".struct_size is " + std::to_string(options->struct_size) +
                   ", not " + std::to_string(sizeof(Options)) + ": call " + name +
                   "_init(), and compile with the wend.h of this library");
  }
  return *options;
}

/// Gives the caller's structure its defaults.
template <class Options>
wend_status init(Options* options, std::size_t struct_size, const Options& defaults) noexcept {
  if (options == nullptr || struct_size != sizeof(Options)) return WEND_INVALID_ARGUMENT;
  *options = defaults;
  return WEND_OK;
}

bool is_finite(const wend_pose& pose);

}  // namespace wend::c
