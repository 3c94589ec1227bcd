#include "wend_ros/silence_watch.hpp"

#include <gtest/gtest.h>

namespace wend_ros {
namespace {

TEST(SilenceWatch, ThePlannerIsSilentUntilItIsHeardAndAfterTheTimeout) {
  SilenceWatch watch({.planner_timeout = 0.5});
  EXPECT_EQ(watch.silent(100), Silent::planner);
  watch.hear_planner(100);
  EXPECT_EQ(watch.silent(100), Silent::nobody);
  EXPECT_EQ(watch.silent(100.5), Silent::nobody);
  EXPECT_EQ(watch.silent(100.6), Silent::planner);
  watch.hear_planner(200);
  EXPECT_EQ(watch.silent(200.1), Silent::nobody) << "it is back";
}

TEST(SilenceWatch, TheMapMayBeSilentUnlessToldSo) {
  SilenceWatch patient({.planner_timeout = 0, .map_timeout = 0});
  EXPECT_EQ(patient.silent(1e9), Silent::nobody);
  SilenceWatch watch({.planner_timeout = 0, .map_timeout = 2});
  EXPECT_EQ(watch.silent(0), Silent::map);
  watch.hear_map(10);
  EXPECT_EQ(watch.silent(12), Silent::nobody);
  EXPECT_EQ(watch.silent(12.1), Silent::map);
}

TEST(SilenceWatch, ThePlannerIsNamedFirst) {
  SilenceWatch watch({.planner_timeout = 1, .map_timeout = 1});
  EXPECT_EQ(watch.silent(0), Silent::planner);
  watch.hear_planner(0);
  EXPECT_EQ(watch.silent(0), Silent::map);
}

}  // namespace
}  // namespace wend_ros
