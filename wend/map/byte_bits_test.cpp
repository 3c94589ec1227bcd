// Bits of bytes: on every machine the same.

#include "wend/map/byte_bits.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "wend/base/random.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {
namespace {

TEST(ByteBits, OfAnswersAreTheSameOnEveryMachine) {
  Random random(3);
  for (int round = 0; round < 1000; ++round) {
    Answers answers;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof answers; ++i) {
      const bool yes = random.chance(0.5);
      answers[i] = yes ? -1 : 0;
      bits |= std::uint64_t{yes} << i;
    }
    ASSERT_EQ(gathered_bits(answers), bits);
    ASSERT_EQ(bits_of(answers), bits);
  }
}

TEST(ByteBits, SetTheCellsOfARow) {
  Random random(4);
  for (int width = 1; width < 260; ++width) {
    std::vector<unsigned char> row(static_cast<std::size_t>(width));
    for (unsigned char& byte : row) byte = static_cast<unsigned char>(random.below(256));
    BitGrid bits(width, 1);
    for_each_block(row, 0, [&](std::size_t x, const unsigned char* block) {
      set_block(bits.row_words(0), x,
                bits_of(block, [](Bytes bytes) { return (bytes >= 77) & (bytes <= 200); }));
    });
    for (int x = 0; x < width; ++x) {
      const int byte = row[static_cast<std::size_t>(x)];
      ASSERT_EQ((bits[{x, 0}]), byte >= 77 && byte <= 200) << x << " of " << width;
    }
    ASSERT_FALSE((bits[{width, 0}])) << "the border stays false";
  }
}

}  // namespace
}  // namespace wend
