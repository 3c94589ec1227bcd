// Coverages of the C interface.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/testing/c_objects.hpp"
#include "wend/cover/plan_coverage.hpp"

namespace wend::test {
namespace {

GridMap room() {
  Grid<CellState> states(40, 30, CellState::free);
  for (int y = 0; y < 30; ++y) states[{0, y}] = states[{39, y}] = CellState::occupied;
  for (int x = 0; x < 40; ++x) states[{x, 0}] = states[{x, 29}] = CellState::occupied;
  return *make_grid_map(states);
}

wend_coverage_options coverage_options(double tool_width) {
  wend_coverage_options options;
  EXPECT_EQ(wend_coverage_options_init(&options, sizeof options), WEND_OK);
  options.tool_width = tool_width;
  return options;
}

Owned<wend_coverage> coverage_of(wend_session* session, const wend_coverage_options& options) {
  return made_object<wend_coverage>([&](wend_coverage** out, wend_error* error) {
    return wend_session_cover(session, &options, out, error);
  });
}

TEST(CCoverage, IsThatOfTheCppInterface) {
  const GridMap map = room();
  const auto session = c_session(c_map(map).get());
  const auto coverage = coverage_of(session.get(), coverage_options(3));
  const auto expected =
      plan_coverage(*make_free_space(map, {.outside = OutsidePolicy::free}), {.tool_width = 3});
  ASSERT_TRUE(expected);
  const std::vector<Point> points = expected->path.points();
  ASSERT_EQ(wend_coverage_pose_count(coverage.get()), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(wend_coverage_poses(coverage.get())[i].x, points[i].x, 1e-9);
    EXPECT_NEAR(wend_coverage_poses(coverage.get())[i].y, points[i].y, 1e-9);
  }
  EXPECT_EQ(wend_coverage_share(coverage.get()), expected->covered_share);
  EXPECT_EQ(wend_coverage_length(coverage.get()), expected->length);
  EXPECT_EQ(wend_coverage_lower_bound(coverage.get()), expected->lower_bound);
  EXPECT_EQ(wend_coverage_turns(coverage.get()), expected->turns);
  const std::uint8_t* cell = wend_coverage_cells(coverage.get());
  for (const Cell at : every_cell(map)) {
    ASSERT_EQ(*cell++, expected->covered[at] ? 1 : (expected->wanted[at] ? 2 : 0));
  }
}

TEST(CCoverage, GoesOnFromWhatIsCovered) {
  const auto session = c_session(c_map(room()).get());
  wend_coverage_options options = coverage_options(3);
  const auto first = coverage_of(session.get(), options);
  options.covered = wend_coverage_cells(first.get());
  options.cell_count = 40U * 30U;
  options.share = wend_coverage_share(first.get());
  const auto rest = coverage_of(session.get(), options);
  EXPECT_EQ(wend_coverage_length(rest.get()), 0);
}

TEST(CCoverage, RefusesWrongArguments) {
  const auto session = c_session(c_map(room()).get());
  const auto status_of = [&](const wend_coverage_options* options) {
    return refusal_of<wend_coverage>([&](wend_coverage** coverage, wend_error* error) {
             return wend_session_cover(session.get(), options, coverage, error);
           })
        .status;
  };
  EXPECT_EQ(status_of(nullptr), WEND_INVALID_ARGUMENT);
  wend_coverage_options options = coverage_options(3);
  options.struct_size = 1;
  EXPECT_EQ(status_of(&options), WEND_INVALID_ARGUMENT);
  for (const double width : {0.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    options = coverage_options(width);
    EXPECT_EQ(status_of(&options), WEND_INVALID_OPTION);
  }
  options = coverage_options(3);
  const std::uint8_t byte = 1;
  options.area = &byte;
  options.cell_count = 1;
  EXPECT_EQ(status_of(&options), WEND_INVALID_ARGUMENT);
  options = coverage_options(3);
  const wend_pose wall{0.5, 0.5, 0};
  options.start = &wall;
  EXPECT_EQ(status_of(&options), WEND_START_BLOCKED);
}

TEST(CCoverage, IsNothingForNull) {
  EXPECT_EQ(wend_coverage_pose_count(nullptr), 0U);
  EXPECT_EQ(wend_coverage_poses(nullptr), nullptr);
  EXPECT_EQ(wend_coverage_cells(nullptr), nullptr);
  EXPECT_TRUE(std::isnan(wend_coverage_share(nullptr)));
  EXPECT_TRUE(std::isnan(wend_coverage_length(nullptr)));
  EXPECT_TRUE(std::isnan(wend_coverage_lower_bound(nullptr)));
  EXPECT_EQ(wend_coverage_turns(nullptr), 0U);
  wend_coverage_free(nullptr);
}

}  // namespace
}  // namespace wend::test
