#include "wend/io/path/trajectory_csv.hpp"

#include <gtest/gtest.h>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

TEST(TrajectoryCsv, HasALineEveryPeriodAndOneForTheEnd) {
  const Frame frame{.resolution = 0.5, .origin = {1, 2, 0}};
  const Path path = Path::along({{0, 0}, {2, 0}});
  const auto trajectory = Trajectory::along(path, frame, {.speed = 1, .acceleration = 2});
  ASSERT_TRUE(trajectory);  // 0.5 s to speed up, 0.5 s at 1 m/s, 0.5 s to brake
  EXPECT_EQ(trajectory_csv(*trajectory, 0.5),
            "t,x,y,heading,v,w\n"
            "0,1,2,0,0,0\n"
            "0.5,1.25,2,0,1,0\n"
            "1,1.75,2,0,1,0\n"
            "1.5,2,2,0,0,0\n");
}

TEST(TrajectoryCsv, OfAFailedPlanSaysWhy) {
  EXPECT_EQ(no_trajectory_csv({"unreachable", "no path joins them"}),
            "# no path: unreachable: no path joins them\nt,x,y,heading,v,w\n");
}

}  // namespace
}  // namespace wend
