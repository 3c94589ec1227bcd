// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/pose_faults.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace wend_nav2 {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(PoseFaults, NumbersThatAreNotFiniteOrAbsurdAreFaults) {
  for (const double number : {std::nan(""), kInfinity, -kInfinity, 1e300, -1e300, 1e9}) {
    EXPECT_TRUE(fault_of(wend::MapPose{number, 0, 0})) << number;
    EXPECT_TRUE(fault_of(wend::MapPose{0, number, 0})) << number;
  }
  for (const double number : {std::nan(""), kInfinity}) {
    EXPECT_EQ(fault_of(wend::MapPose{0, 0, number}), "contains NaN or infinity");
  }
  // Both are infinite, and their sum is none.
  EXPECT_TRUE(fault_of(wend::MapPose{kInfinity, -kInfinity, 0}));
  EXPECT_EQ(fault_of(wend::MapPose{0, 0, -1e300}), "has a heading of more than 1e+06 rad");
  EXPECT_FALSE(fault_of(wend::MapPose{5e6, -5e6, 7}));
}

TEST(PoseFaults, OfAPathNameThePlace) {
  std::vector<wend::MapPose> path(30, wend::MapPose{1, 2, 3});
  EXPECT_FALSE(fault_of(path));
  path[20].x = std::nan("");
  EXPECT_EQ(fault_of(path), "pose 20 of the path, (nan, 2), contains NaN or infinity");
  path[7] = {1e300, 1.234, 0};
  EXPECT_EQ(fault_of(path),
            "pose 7 of the path, (1e+300, 1.23), is farther than 1e+08 m from the origin of its "
            "frame");
  EXPECT_FALSE(fault_of(std::vector<wend::MapPose>{}));
}

}  // namespace
}  // namespace wend_nav2
