#include "wend/space/se2/motion_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/space/se2/coarse_cost_field.hpp"
#include "wend/space/se2/coarse_grid.hpp"

namespace wend {
namespace {

FreeSpace random_space(Random& random, const Footprint& footprint) {
  const int width = random.between(6, 20);
  const int height = random.between(6, 20);
  Grid<CellState> states(width, height, CellState::free);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (random.chance(0.06)) states[{x, y}] = CellState::occupied;
    }
  }
  return *make_free_space(*make_grid_map(states), {.footprint = footprint});
}

Motion random_motion(Random& random) {
  const double length = 6 * random.uniform() - 3;
  return {length, random.chance(0.3) ? 0 : length * (2 * random.uniform() - 1) / 2, 0};
}

/// Places along a motion, close to each other.
template <class Visit>
void for_each_place(const Pose& from, const Motion& motion, Visit&& visit) {
  constexpr int kPlaces = 300;
  for (int i = 0; i <= kPlaces; ++i) {
    visit(pose_after(from, part_of(motion, static_cast<double>(i) / kPlaces)));
  }
}

struct Shapes {
  std::string shape;
  std::string larger;  // covers the shape and what is near it
};

void PrintTo(const Shapes& shapes, std::ostream* stream) { *stream << shapes.shape; }

class MotionsOf : public ::testing::TestWithParam<Shapes> {};

/// A motion that the check lets pass is free at every place. What it refuses is blocked for a robot that is a
/// little larger.
TEST_P(MotionsOf, AreFreeWhereTheyPassAndTightWhereTheyDoNot) {
  const Footprint footprint = *parse_footprint(GetParam().shape);
  const Footprint grown = *parse_footprint(GetParam().larger);
  int passed = 0;
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = random_space(random, footprint);
    const FreeSpace larger = *make_free_space(space.obstacles(), {.footprint = grown});
    const MotionCheck check(space);
    const Pose from{space.width() * random.uniform(), space.height() * random.uniform(),
                    2 * kPi * random.uniform()};
    if (!space.fits(from)) continue;
    const Motion motion = random_motion(random);
    bool free = true;
    bool wide = true;
    for_each_place(from, motion, [&](const Pose& pose) {
      free = free && space.fits(pose);
      wide = wide && larger.fits(pose);
    });
    if (check.fits(from, motion)) {
      ++passed;
      EXPECT_TRUE(free);
    } else {
      ++refused;
      EXPECT_FALSE(wide);
    }
  }
  EXPECT_GT(passed, 100);
  EXPECT_GT(refused, 100);
}

INSTANTIATE_TEST_SUITE_P(
    Footprints, MotionsOf,
    ::testing::Values(Shapes{"disc:0.45", "disc:0.5625"}, Shapes{"disc:1.2", "disc:1.5"},
                      Shapes{"1,0.5;-0.6,0.5;-0.6,-0.5;1,-0.5",
                             "1.25,0.625;-0.75,0.625;-0.75,-0.625;1.25,-0.625"},
                      Shapes{"1,0.6;0,0.2;-1,0.6;-1,-0.6;0,-0.4;1,-0.6",
                             "1.25,0.75;0,0.25;-1.25,0.75;-1.25,-0.75;0,-0.5;1.25,-0.75"},
                      Shapes{"rect:1.6x0.8,0.8", "rect:2x1.2,0.8"},
                      Shapes{"rect:1.4x1,1.6", "rect:1.8x1.4,1.6"},
                      Shapes{"2,0.6;0.4,0.6;0.4,0.2;1.4,0.2;1.4,-0.6;2,-0.6",
                             "2.2,0.8;0.2,0.8;0.2,0;1.2,0;1.2,-0.8;2.2,-0.8"}));

/// A circle of hundreds of corners is blocked where its inner disc is, and free where the disc around it is.
TEST(MotionCheck, TakesHundredsOfCorners) {
  std::vector<Point> corners;
  constexpr int kCorners = 300;
  for (int i = 0; i < kCorners; ++i) {
    const auto [sine, cosine] = sine_and_cosine(2 * kPi * i / kCorners);
    corners.push_back({1.4 * cosine, 1.4 * sine});
  }
  const Footprint round = *Footprint::polygon(*Polygon::make(corners));
  int decided = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = random_space(random, round);
    const auto disc = [&](double radius) {
      return *make_free_space(space.obstacles(), {.footprint = Footprint::disc(radius)});
    };
    const FreeSpace around = disc(1.4 + 1e-9);
    const FreeSpace within = disc(1.3);
    const Pose from{space.width() * random.uniform(), space.height() * random.uniform(), 0};
    if (!space.fits(from)) continue;
    const Motion motion = random_motion(random);
    const bool fits = MotionCheck(space).fits(from, motion);
    if (around.fits(from) && MotionCheck(around).fits(from, motion)) {
      ++decided;
      EXPECT_TRUE(fits);
    }
    if (!MotionCheck(within).fits(from, motion)) {
      ++decided;
      EXPECT_FALSE(fits);
    }
  }
  EXPECT_GT(decided, 50);
}

TEST(MotionCheck, NeverCrossesAThinWall) {
  Grid<CellState> states(40, 9, CellState::free);
  for (int y = 0; y < 9; ++y) states[{20, y}] = CellState::occupied;
  const FreeSpace space =
      *make_free_space(*make_grid_map(states), {.footprint = Footprint::disc(0.4)});
  const MotionCheck check(space);
  for (double length = 1; length < 38; length += 0.37) {
    const bool reaches = 1.5 + length > 20 - 0.4;
    EXPECT_EQ(check.fits({1.5, 4.5, 0}, {length, 0, 0}), !reaches) << length;
  }
}

TEST(MotionCheck, CountsTheCostsOfTheCellsOfTheWay) {
  Grid<CellState> states(20, 5, CellState::free);
  Grid<double> terrain(20, 5, 1);
  for (int y = 0; y < 5; ++y) {
    for (int x = 10; x < 20; ++x) terrain[{x, y}] = 3;
  }
  const FreeSpace space = *make_free_space(*make_grid_map(states, {}, terrain), {});
  const MotionCheck check(space);
  EXPECT_DOUBLE_EQ(check.cost({5, 2.5, 0}, {10, 0, 0}), 5 * 1 + 5 * 3);
  EXPECT_DOUBLE_EQ(check.cost_of_way({15, 2.5, kPi}, {10, 0, 0}), 5 * 1 + 5 * 3);
}

/// No way on the field is shorter than the line, and none is much longer where nothing is in the way. What a field
/// says before it has settled a place is no more than what it settles.
TEST(SquareCostField, IsNearTheDistanceAndItsBoundsHold) {
  const FreeSpace space = *make_free_space(
      *make_grid_map(Grid<CellState>(120, 90, CellState::free)), {.footprint = Footprint::disc(3)});
  const CoarseGrid grid(space, cells_to_drive_in(space), 3);
  CoarseCostField field(grid);
  const Point goal{20.5, 30.5};
  const CoarseCostField::Seed seed{goal, [&](Point at) { return straight_distance(at, goal); }, 12};
  field.begin({&seed, 1}, {100, 70});
  field.settle({100, 70});
  for (double x = 10; x < 110; x += 7) {
    for (double y = 10; y < 80; y += 7) {
      const CoarseCostField::Value before = field.at({x, y});
      field.settle({x, y});
      const CoarseCostField::Value after = field.at({x, y});
      ASSERT_TRUE(after.exact);
      EXPECT_LE(before.cost, after.cost + 1e-3);
      const double line = straight_distance({x, y}, goal);
      EXPECT_GE(after.cost, line - 0.1);
      EXPECT_LE(after.cost, 1.06 * line + 1);
    }
  }
}

}  // namespace
}  // namespace wend
