// Sessions of the C interface after random sequences of calls: their answers are those of a new session on the same
// map, and their paths are free. The calls are those of the fuzzer `session`, which looks longer.

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/fuzzed_session.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"

namespace wend::test {
namespace {

TEST(SessionCalls, ChangeNoAnswerByWhatCameBefore) {
  for (std::uint64_t seed = 1; seed <= share_of(200U) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::string bytes;
    for (std::size_t i = 0; i < 700; ++i) bytes += static_cast<char>(random.below(256));
    EXPECT_EQ(fuzz_session(bytes), "");
  }
}

}  // namespace
}  // namespace wend::test
