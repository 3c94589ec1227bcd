// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_pieces.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace wend_nav2 {
namespace {

using Poses = std::vector<wend::MapPose>;

TEST(PathPieces, ReversalsAndTurnsInPlaceAreCuts) {
  EXPECT_EQ(cuts_of(Poses{{0, 0, 1}, {0, 1, 1}, {0, 2, 1}, {0, 1.5, 1}, {0, 1, 1}, {0, 1.5, 1}}),
            (std::vector<std::size_t>{0, 2, 4, 5}));
  EXPECT_EQ(cuts_of(Poses{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {1, 1, 1}}),
            (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(PathPieces, MostOfItsWayDecidesHowAPieceIsDriven) {
  EXPECT_TRUE(in_reverse(Poses{{2, 0, 0}, {1, 0, 0}, {0, 0, 0}}));
  EXPECT_FALSE(in_reverse(Poses{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_TRUE(in_reverse(Poses{{0, 0, 1}, {0, -1, 1}, {0, -0.9, 1}}));
}

TEST(PathPieces, ABendOfARightAngleIsNotACut) {
  EXPECT_EQ(cuts_of(Poses{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(cuts_of(Poses{{0, 0, 0}, {1, 0, 0}, {0.9, 1, 0}}), (std::vector<std::size_t>{0, 1, 2}));
}

}  // namespace
}  // namespace wend_nav2
