#include "wend/jump/bit_lines.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "wend/base/random.hpp"

namespace wend {
namespace {

/// Sizes around multiples of the word size.
const std::vector<std::pair<int, int>>& sizes() {
  static const std::vector<std::pair<int, int>> all{{1, 1},   {1, 200},  {3, 61},  {5, 62},
                                                    {7, 63},  {9, 64},   {64, 65}, {65, 127},
                                                    {130, 1}, {66, 128}, {63, 190}};
  return all;
}

BitLines random_lines(Random& random, int lines, int length, double share) {
  BitLines bits(lines, length);
  for (int line = 0; line < lines; ++line) {
    for (int at = 0; at < length; ++at) {
      if (random.chance(share)) bits.set(line, at);
    }
  }
  return bits;
}

template <class Check>
void on_random_lines(Check&& check) {
  Random random(7);
  for (const auto& [lines, length] : sizes()) {
    for (const double share : {0.02, 0.5, 0.97}) {
      SCOPED_TRACE(std::to_string(lines) + " x " + std::to_string(length));
      check(random_lines(random, lines, length, share));
    }
  }
}

TEST(BitLines, ScansStopAtTheNextSetBit) {
  on_random_lines([](const BitLines& bits) {
    for (int line = 0; line < bits.lines(); ++line) {
      for (int at = 0; at < bits.length(); ++at) {
        int ahead = at + 1;
        while (ahead < bits.length() && !bits.get(line, ahead)) ++ahead;
        if (ahead < bits.length()) {
          EXPECT_EQ(bits.distance_ahead(line, at), ahead - at);
        }
        int back = at - 1;
        while (back >= 0 && !bits.get(line, back)) --back;
        if (back >= 0) {
          EXPECT_EQ(bits.distance_back(line, at), at - back);
        }
      }
    }
  });
}

TEST(BitLines, AllSetIsTrueUpToTheFirstZero) {
  on_random_lines([](const BitLines& bits) {
    for (int line = 0; line < bits.lines(); line += 3) {
      for (int at = 0; at < bits.length(); ++at) {
        int zero = at;
        while (zero < bits.length() && bits.get(line, zero)) ++zero;
        for (int count = 0; at + count <= bits.length(); ++count) {
          EXPECT_EQ(bits.all_set(line, at, count), at + count <= zero) << at << " + " << count;
        }
      }
    }
  });
}

TEST(BitLines, TransposedLinesArePlaces) {
  on_random_lines([](const BitLines& bits) {
    const BitLines turned = bits.transposed();
    EXPECT_EQ(turned.lines(), bits.length());
    EXPECT_EQ(turned.length(), bits.lines());
    for (int line = -1; line <= bits.lines(); ++line) {
      for (int at = -1; at <= bits.length(); ++at) {
        EXPECT_EQ(turned.get(at, line), bits.get(line, at));
      }
    }
    EXPECT_EQ(turned.transposed(), bits);
  });
}

TEST(BitLines, DiagonalsHoldEveryBitOnce) {
  on_random_lines([](const BitLines& bits) {
    const BitLines right = bits.diagonals(BitLines::Diagonals::falling_right);
    const BitLines left = bits.diagonals(BitLines::Diagonals::falling_left);
    EXPECT_EQ(right.lines(), bits.lines() + bits.length() - 1);
    EXPECT_EQ(left.length(), bits.lines());
    for (int line = 0; line < bits.lines(); ++line) {
      for (int at = 0; at < bits.length(); ++at) {
        EXPECT_EQ(right.get(at - line + bits.lines() - 1, line), bits.get(line, at));
        EXPECT_EQ(left.get(at + line, line), bits.get(line, at));
      }
    }
  });
}

}  // namespace
}  // namespace wend
