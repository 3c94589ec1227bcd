#pragma once

// How many cases a test takes that draws them at random.

namespace wend::test {

/// All of them; a quarter under the address sanitizer, where a case takes several times as long.
template <class Count>
constexpr Count share_of(Count cases) {
#ifdef __SANITIZE_ADDRESS__
  return (cases + 3) / 4;
#else
  return cases;
#endif
}

}  // namespace wend::test
