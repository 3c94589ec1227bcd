#include "loaders.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return wend::test::fuzz_or_abort("stop_csv", data, size);
}
