#pragma once

// The loaders that are fuzzed, and what is done with a path that was loaded: each takes any bytes at all and returns what it did wrong, empty if
// nothing. tests/fuzz/<loader>_fuzzer.cpp gives them to libFuzzer; tests/fuzz_regressions_test.cpp
// replays the files in tests/fuzz/seeds/<loader> and tests/fuzz/regressions/<loader>.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace wend::test {

struct Loader {
  std::string_view name;
  std::string (*fuzz)(std::string_view bytes);
};

std::span<const Loader> fuzzed_loaders();

/// For LLVMFuzzerTestOneInput: ends the program if the loader did something wrong.
int fuzz_or_abort(std::string_view loader, const std::uint8_t* data, std::size_t size);

}  // namespace wend::test
