#include "loaders.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return wend::test::fuzz_or_abort("nav2", data, size);
}
