// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/standing_watch.hpp"

#include <gtest/gtest.h>

namespace wend_nav2 {
namespace {

TEST(StandingWatch, CountsWhileTheRobotIsNearOnePlace) {
  StandingWatch watch;
  EXPECT_EQ(watch.standing_for({1, 1, 3}, 1, 0.05, 0.1), 0);
  EXPECT_EQ(watch.standing_for({1.03, 1, 3}, 1, 0.05, 0.1), 1);
  EXPECT_EQ(watch.standing_for({0.97, 1, -3.24}, 1, 0.05, 0.1), 2) << "over a half turn";
  EXPECT_EQ(watch.standing_for({1.06, 1, 3}, 1, 0.05, 0.1), 0) << "it came on";
  EXPECT_EQ(watch.standing_for({1.06, 1, 3}, 1, 0.05, 0.1), 1);
  EXPECT_EQ(watch.standing_for({1.06, 1, 2.8}, 1, 0.05, 0.1), 0) << "it turned";
  watch.restart();
  EXPECT_EQ(watch.standing_for({1.06, 1, 2.8}, 1, 0.05, 0.1), 0);
}

}  // namespace
}  // namespace wend_nav2
