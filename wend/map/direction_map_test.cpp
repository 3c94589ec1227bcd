#include "wend/map/direction_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "conformance/random_directions.hpp"
#include "conformance/random_map.hpp"
#include "wend/map/masked.hpp"
#include "wend/map/own_costs.hpp"

namespace wend {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kForbidden = std::numeric_limits<double>::infinity();

GridMap open_map(int width, int height, const Frame& frame = {}) {
  return *make_grid_map(Grid<CellState>(width, height, CellState::free), frame);
}

GridMap with_one_arrow(double heading, const ArrowOptions& options, const Frame& frame = {}) {
  return *with_arrows(open_map(1, 1, frame), Grid<double>(1, 1, heading), options);
}

double factor_at(const GridMap& map, double heading) {
  return map.directions()->rule({0, 0}).factor(heading);
}

TEST(DirectionMap, AnArrowLetsPassWhatIsWithinItsTolerance) {
  const GridMap strict = with_one_arrow(0, {});
  EXPECT_EQ(factor_at(strict, 0), 1);
  EXPECT_EQ(factor_at(strict, kPi / 2), 1) << "across";
  EXPECT_EQ(factor_at(strict, kPi / 2 + 0.01), kForbidden);
  EXPECT_EQ(factor_at(strict, kPi), kForbidden);
  const GridMap dear = with_one_arrow(kPi - 0.1, {.tolerance = 0.3, .factor = 2.5});
  EXPECT_EQ(factor_at(dear, -kPi + 0.1), 1) << "over the half turn";
  EXPECT_EQ(factor_at(dear, 0), 2.5);
}

TEST(DirectionMap, HeadingsAreInTheFrameOfTheMap) {
  const GridMap turned = with_one_arrow(1.2, {}, {.origin = {0, 0, 0.7}});
  EXPECT_NEAR(turned.directions()->rule({0, 0}).arrows.front().heading, 0.5, 1e-12);
}

TEST(DirectionMap, ASlopeCostsUpAndDownAndNothingAcross) {
  Grid<double> heights(3, 1, 0);
  heights[{1, 0}] = 0.5;
  heights[{2, 0}] = 1;
  const GridMap ramp = *with_heights(open_map(3, 1, {.resolution = 0.5, .metric = true}), heights,
                                     {.climb = 10, .descend = 3});
  const DirectionRule& rule = ramp.directions()->rule({1, 0});
  EXPECT_DOUBLE_EQ(rule.factor(0), 11) << "a metre up in a metre";
  EXPECT_DOUBLE_EQ(rule.factor(kPi), 4);
  EXPECT_DOUBLE_EQ(rule.factor(kPi / 2), 1);
}

TEST(DirectionMap, StepsHaveTheFactorOfTheirHeading) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GridMap map = test::with_random_directions(random, open_map(4, 3));
    for (const Cell cell : every_cell(map)) {
      for (int i = 0; i < kDirections; ++i) {
        const auto direction = static_cast<Direction>(i);
        const Cell by = step({0, 0}, direction);
        const double heading = std::atan2(by.y, by.x);
        const std::uint32_t factor = map.directions()->factor(cell, direction);
        EXPECT_EQ(factor, map.directions()->factor(cell, heading));
        EXPECT_EQ(factor == DirectionMap::kForbidden,
                  std::isinf(map.directions()->rule(cell).factor(heading)));
        EXPECT_TRUE(factor == DirectionMap::kForbidden || factor >= DirectionMap::kOne);
      }
    }
  }
}

TEST(DirectionMap, LayersMultiplyInAnyOrder) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GridMap map = open_map(5, 4);
    const GridMap a = test::with_random_directions(random, map);
    const GridMap b = test::with_random_directions(random, map);
    const GridMap ab = *masked(a, b);
    const GridMap ba = *masked(b, a);
    for (const Cell cell : every_cell(map)) {
      EXPECT_EQ(ab.directions()->rule(cell), ba.directions()->rule(cell));
      const double heading = 6 * random.uniform();
      const double product =
          a.directions()->rule(cell).factor(heading) * b.directions()->rule(cell).factor(heading);
      const double both = ab.directions()->rule(cell).factor(heading);
      EXPECT_TRUE(both == product || std::abs(both - product) < 1e-9 * product);
    }
  }
}

TEST(DirectionMap, AMaskLiesOnTheMapAsItIsTurned) {
  const Frame frame{.resolution = 1, .origin = {0, 0, 0}, .y_up = true, .metric = true};
  const Frame turned{.resolution = 1, .origin = {4, 0, kPi / 2}, .y_up = true, .metric = true};
  const GridMap mask =
      *with_arrows(open_map(4, 4, turned), Grid<double>(4, 4, kPi / 2));  // in its frame: up
  const GridMap map = *masked(open_map(4, 4, frame), mask);
  EXPECT_NEAR(map.directions()->rule({2, 1}).arrows.front().heading, kPi / 2, 1e-9)
      << "in metres it leads where it led";
}

TEST(DirectionMap, AnImageOfTheSameSizeLiesOnTheMapAsItIsDrawn) {
  const GridMap mask = *with_arrows(open_map(2, 2), Grid<double>(2, 2, -kPi / 2));  // up, y down
  const Frame frame{.resolution = 0.05, .y_up = true, .metric = true};
  const GridMap map = *masked(open_map(2, 2, frame), mask);
  EXPECT_NEAR(map.directions()->rule({0, 0}).arrows.front().heading, kPi / 2, 1e-12);
}

TEST(DirectionMap, SlopesOfAMaskWithoutAResolutionAreInTheUnitOfTheMap) {
  Grid<double> heights(2, 1, 0);
  heights[{1, 0}] = 0.1;
  const GridMap mask = *with_heights(open_map(2, 1), heights, {.climb = 1});
  const GridMap map = *masked(open_map(2, 1, {.resolution = 0.05, .metric = true}), mask);
  EXPECT_NEAR(map.directions()->rule({0, 0}).slopes.front().rise_x, 2, 1e-12);
}

TEST(DirectionMap, StaysWithTheMapThroughEditsAndOtherCosts) {
  GridMap map = with_one_arrow(0, {});
  MapEdit edit;
  edit.cells = {{{0, 0}, CellState::occupied}};
  ASSERT_TRUE(map.edit(edit));
  EXPECT_NE(map.directions(), nullptr);
  EXPECT_NE(with_terrain(map, Grid<double>())->directions(), nullptr);
}

TEST(DirectionMap, RefusesOtherSizesAndNumbersOutOfRange) {
  const GridMap map = open_map(2, 2);
  EXPECT_EQ(with_arrows(map, Grid<double>(2, 1, 0.0)).error().message,
            "the headings have 2 x 1 cells, the map 2 x 2: the same size expected");
  Grid<double> headings(2, 2, kNone);
  headings[{1, 0}] = kForbidden;
  EXPECT_EQ(with_arrows(map, headings).error().message,
            "cell (1,0) of the headings is inf: a number within 1e9 expected, or NaN for none");
  const Grid<double> right(2, 2, 0.0);
  EXPECT_EQ(with_arrows(map, right, {.tolerance = 4}).error().message,
            "tolerance is 4: an angle from 0 to half a turn expected");
  EXPECT_EQ(with_arrows(map, right, {.tolerance = kNone}).error().status, Status::invalid_option);
  EXPECT_EQ(with_arrows(map, right, {.factor = 0.5}).error().message,
            "factor is 0.5: a factor from 1 to 10000, or infinity expected");
  EXPECT_EQ(with_heights(map, right, {.climb = -1}).error().message,
            "climb is -1: a number from 0 to 10000 expected");
  EXPECT_EQ(with_heights(map, right, {.descend = kForbidden}).error().status,
            Status::invalid_option);
}

}  // namespace
}  // namespace wend
