#include "wend/robot/repeated_moves.hpp"

#include <gtest/gtest.h>

#include "wend/base/random.hpp"

namespace wend {
namespace {

TEST(RepeatedMoves, AreTheMovesAgainWhenTheyAreRepeated) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    std::vector<std::string_view> moves;
    for (int i = random.between(0, 12); i > 0; --i)
      moves.push_back(random.chance(0.6) ? "FWD" : "REV");
    std::vector<std::string_view> repeated;
    std::string_view last;
    for (const RepeatedMove& move : merged_moves(moves)) {
      EXPECT_NE(move.name, last) << "merged with the one before";
      last = move.name;
      repeated.insert(repeated.end(), move.times, move.name);
      EXPECT_EQ(move.end, repeated.size());
    }
    EXPECT_EQ(repeated, moves);
  }
}

TEST(RepeatedMoves, SayHowOften) {
  EXPECT_EQ(text_of(RepeatedMove{"FWD", 3, 3}), "3 x FWD");
  EXPECT_EQ(text_of(RepeatedMove{"FWD_RIGHT", 1, 4}), "FWD_RIGHT");
}

}  // namespace
}  // namespace wend
