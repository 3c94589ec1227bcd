#include "wend/path/motion_tree.hpp"

#include <gmock/gmock.h>

#include <array>

namespace wend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Pose kFirst{1, 1, 0};
constexpr Pose kNext{2, 1, 0};
constexpr Pose kLast{3, 2, 1};

TEST(MotionTree, HasABranchForEachExpansion) {
  MotionTree tree;
  EXPECT_TRUE(tree.empty());
  tree.add(std::array{kFirst});
  tree.add({});
  tree.add(std::array{kFirst, kNext, kLast});
  ASSERT_EQ(tree.size(), 3U);
  EXPECT_THAT(tree.branch(0), ElementsAre(kFirst));
  EXPECT_THAT(tree.branch(1), IsEmpty());
  EXPECT_THAT(tree.branch(2), ElementsAre(kFirst, kNext, kLast));
  tree.clear();
  EXPECT_TRUE(tree.empty());
}

TEST(MotionTree, BeginsWithItsFirstBranches) {
  MotionTree tree;
  tree.add(std::array{kFirst});
  tree.add(std::array{kFirst, kNext});
  EXPECT_TRUE(tree.beginning(0).empty());
  EXPECT_EQ(tree.beginning(1).size(), 1U);
  EXPECT_EQ(tree.beginning(9).size(), 2U);
  EXPECT_THAT(tree.beginning(2).branch(1), ElementsAre(kFirst, kNext));
  EXPECT_TRUE(MotionTree().beginning(1).empty());
}

}  // namespace
}  // namespace wend
