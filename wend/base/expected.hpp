#pragma once

// Expected<T, E>: a value, or the error. wend does not throw on invalid input.
//
//   wend::Expected<int, std::string> parsed = ...;
//   if (!parsed) report(parsed.error());
//
// An alias of tl::expected, to become std::expected once every compiler we support has it.

#include <tl/expected.hpp>

namespace wend {

/// A value of type T, or an error of type E. Test it before you read the value.
template <class T, class E>
using Expected = tl::expected<T, E>;

/// An error, for `return` from a function that returns an Expected. failure() makes one of an
/// Error.
template <class E>
using Unexpected = tl::unexpected<E>;

}  // namespace wend
