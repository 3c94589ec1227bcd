#pragma once

// Expected<T, E>: a value, or the error. wend does not throw on invalid input.
//
//   wend::Expected<int, std::string> parsed = ...;
//   if (!parsed) report(parsed.error());
//
// An alias of tl::expected, to become std::expected once every compiler we support has it.

#include <tl/expected.hpp>

namespace wend {

template <class T, class E>
using Expected = tl::expected<T, E>;

template <class E>
using Unexpected = tl::unexpected<E>;

}  // namespace wend
