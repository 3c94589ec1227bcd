#include "wend/path/path_fault.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/testing/drawn_map.hpp"
#include "wend/robot/near_map.hpp"

namespace wend {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

FreeSpace in_metres() {
  return *make_free_space(*make_grid_map(Grid<CellState>(20, 10, CellState::free),
                                         {.resolution = 0.5, .origin = {1, 2, 0}, .metric = true}));
}

TEST(PathFault, NamesThePointAndWhatIsWrongWithIt) {
  const auto nan = fault_of(Path::along({{1, 1}, {2, kNan}}), in_metres());
  ASSERT_TRUE(nan);
  EXPECT_EQ(nan->status, Status::unsupported_query);
  EXPECT_EQ(nan->message, "point 1 of the path, (2,nan) m, contains NaN or infinity");
  EXPECT_EQ(nan->where, "point 1");
  const auto far = fault_of(Path::along({{1e300, 1}}));
  ASSERT_TRUE(far);
  EXPECT_EQ(far->message,
            "point 0 of the path, (1e+300,1), is too far away: at most 1073741824 cells from the "
            "origin of the grid expected");
  const auto turned = fault_of(Path::through({{1, 1, 1e7}}));
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->message,
            "point 0 of the path, (1,1), has the heading 1e+07: at most 1e+06 rad expected");
  EXPECT_EQ(fault_of(Path{})->message, "the path is empty");
}

TEST(PathFault, KnowsTheMap) {
  const FreeSpace space = in_metres();
  EXPECT_FALSE(fault_of(Path({{0, 0}, {19, 9}}), space));
  EXPECT_FALSE(fault_of(Path({{19, 9}, {20, 9}}), space)) << "first_collision() says that";
  EXPECT_FALSE(fault_of(Path::along({{-1000, 0}, {1020, 1010}}), space)) << "off the map, and near";
  EXPECT_EQ(fault_of(Path::along({{-1001, 0}}), space)->message,
            "point 0 of the path, (-499.5,2) m, is too far off the map: at most 1000 cells off its "
            "20 x 10 cells expected");
  EXPECT_FALSE(fault_of(Path::along({{-1001, 0}}))) << "there, numbers are exact";
}

TEST(NearMap, IsFalseForNumbersThatAreNone) {
  const FreeSpace space = in_metres();
  EXPECT_TRUE(near_map(space, Point{-1000, 1010}));
  for (const double number : {kNan, -1000.5, 1e300, std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(near_map(space, Point{number, 1})) << number;
    EXPECT_FALSE(near_map(space, Line{{1, 1}, {1, number}})) << number;
    EXPECT_FALSE(near_map(space, Pose{1, number, 0})) << number;
  }
  EXPECT_FALSE(near_map(space, Pose{1, 1, 1e7}));
  EXPECT_TRUE(near_map(space, Arc{{1, 1, 0}, 9, 0.1}));
  EXPECT_FALSE(near_map(space, Arc{{1, 1, 0}, 1e9, 0}));
  EXPECT_FALSE(near_map(space, Arc{{1, 1, 0}, 10, 2})) << "more than two full turns";
  EXPECT_FALSE(near_map(space, TurnInPlace{{1, 1, 0}, kNan}));
}

}  // namespace
}  // namespace wend
