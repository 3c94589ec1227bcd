#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/base/random.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using test::drawn_space;
using ::testing::HasSubstr;

constexpr double kRadius = 3;  // cells

FreeSpace random_yard(Random& random, const Footprint& footprint) {
  const int width = random.between(15, 40);
  const int height = random.between(15, 40);
  Grid<CellState> states(width, height, CellState::free);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (random.chance(0.02)) states[{x, y}] = CellState::occupied;
    }
  }
  return *make_free_space(*make_grid_map(states), {.footprint = footprint});
}

Query random_query(Random& random, const FreeSpace& space) {
  const auto pose = [&] {
    return Pose{space.width() * random.uniform(), space.height() * random.uniform(),
                normalized_angle(2 * kPi * random.uniform())};
  };
  const Pose start = pose();
  return {start, {Goal(pose())}};
}

std::unique_ptr<Planner> planner_on(const FreeSpace& space, HybridAStarOptions options = {}) {
  options.turning_radius = kRadius;
  return *make_planner(space, options);
}

class HybridAStar : public ::testing::TestWithParam<std::string> {
 protected:
  Footprint footprint() const { return *parse_footprint(GetParam()); }
};

TEST_P(HybridAStar, FindsFreePathsThatKeepTheTurningRadiusAndEndExactly) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = random_yard(random, footprint());
    const Query query = random_query(random, space);
    const auto plan = planner_on(space)->plan(query);
    if (!plan) continue;
    ++found;
    EXPECT_FALSE(first_collision(plan->path, space));
    EXPECT_GE(measure(plan->path, space)->smallest_turning_radius, kRadius * (1 - 1e-6));
    const auto poses = plan->path.driven_poses();
    EXPECT_EQ(poses.front(), query.start);
    EXPECT_LT(plan->goal_snapping_error.distance, 1e-6);
    EXPECT_LT(plan->goal_snapping_error.turn, 1e-6);
    EXPECT_GE(plan->cost, plan->path.length() - 1e-6);
  }
  EXPECT_GT(found, 50);
}

INSTANTIATE_TEST_SUITE_P(Footprints, HybridAStar,
                         ::testing::Values("disc:1", "1.5,0.8;-1,0.8;-1,-0.8;1.5,-0.8"));

/// What is driven ahead one way is driven ahead the other way by a robot that faces back.
TEST(HybridAStarReversed, SolvesTheReversedQueryAtNearlyTheSameCost) {
  double there = 0;
  double back = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = random_yard(random, Footprint::disc(1));
    const Query query = random_query(random, space);
    const auto planner = planner_on(space);
    const auto plan = planner->plan(query);
    const auto flipped = [](double heading) { return normalized_angle(heading + kPi); };
    const Goal& goal = query.goals.front();
    const Query reversed{{goal.point.x, goal.point.y, flipped(*goal.heading)},
                         {Goal(Pose{query.start.x, query.start.y, flipped(query.start.heading)})}};
    const auto other = planner->plan(reversed);
    ASSERT_EQ(plan.has_value(), other.has_value());
    if (!plan) continue;
    there += plan->cost;
    back += other->cost;
  }
  EXPECT_NEAR(back / there, 1, 0.03);
}

TEST(HybridAStarModels, MoveAsTheyMay) {
  const FreeSpace space = drawn_space(
      "..............\n"
      "..............\n"
      "..............\n"
      "..............\n"
      "..............\n");
  const Query query{{3.5, 2.5, 0}, {Goal(Pose{10.5, 2.5, kPi})}};
  const auto moves_of = [&](DriveKind kind) {
    HybridAStarOptions options;
    options.motion_model = kind;
    options.turning_radius = 1;
    const auto plan = (*make_planner(space, options))->plan(query);
    EXPECT_TRUE(plan);
    bool reverse = false;
    bool arc = false;
    bool spin = false;
    for (const Segment& segment : plan->path.segments()) {
      reverse = reverse || segment.length < 0;
      arc = arc || (segment.length != 0 && segment.turn != 0);
      spin = spin || (segment.length == 0 && segment.turn != 0);
    }
    return std::vector<bool>{reverse, arc, spin};
  };
  EXPECT_EQ(moves_of(DriveKind::dubins)[0], false);
  EXPECT_EQ(moves_of(DriveKind::dubins)[2], false);
  EXPECT_EQ(moves_of(DriveKind::reeds_shepp)[2], false);
  EXPECT_EQ(moves_of(DriveKind::differential), (std::vector<bool>{false, false, true}));
  EXPECT_EQ(moves_of(DriveKind::omni)[1], false);
}

TEST(HybridAStarFailures, AreToldApart) {
  const FreeSpace space = drawn_space(
      ".........#....\n"
      ".........#....\n"
      ".........#....\n");
  const auto planner = *make_planner(space, HybridAStarOptions{});
  const auto wall = planner->plan({{1.5, 1.5, 0}, {Goal(Pose{12.5, 1.5, 0})}});
  ASSERT_FALSE(wall);
  EXPECT_EQ(wall.error().status, Status::unreachable);
  EXPECT_EQ(wall.error().metrics.expanded, 0U);
  ASSERT_EQ(wall.error().failure.causes.size(), 1U);
  const auto* const why = std::get_if<NoDriveFound>(&wall.error().failure.causes.front());
  ASSERT_NE(why, nullptr);
  EXPECT_EQ(why->why, NoDriveFound::Why::parted);
  EXPECT_EQ(planner->plan({{9.5, 1.5, 0}, {Goal(Pose{1.5, 1.5, 0})}}).error().status,
            Status::start_blocked);
  EXPECT_EQ(planner->plan({{1.5, 1.5, 0}, {Goal(Pose{40.5, 1.5, 0})}}).error().status,
            Status::goal_outside);
  EXPECT_EQ(planner->plan({{1.5, 1.5, std::nan("")}, {Goal(Pose{3.5, 1.5, 0})}}).error().status,
            Status::unsupported_query);
}

TEST(HybridAStarGoals, APlaceWithinTheToleranceThatIsWalledInHidesNoOther) {
  const FreeSpace space = drawn_space(
      "...............\n"
      "...............\n"
      "...............\n"
      "...........###.\n"
      "...........#.#.\n"
      "...........###.\n"
      "...............\n");
  const auto planner = planner_on(space);
  Goal goal(Point{12.5, 4.5});
  EXPECT_EQ(planner->plan({{2.5, 1.5, 0}, {goal}}).error().status, Status::unreachable);
  goal.tolerance = 4;
  const auto plan = planner->plan({{2.5, 1.5, 0}, {goal}});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_LE(distance(plan->path.driven_poses().back().point(), goal.point), goal.tolerance);
}

TEST(HybridAStarOptions, ACarNeedsATurningRadius) {
  const FreeSpace space = drawn_space("....\n....\n");
  const auto car = make_planner("hybrid_astar", space, {{"turning_radius", "0"}});
  ASSERT_FALSE(car);
  EXPECT_EQ(car.error().status, Status::invalid_option);
  EXPECT_THAT(car.error().message, HasSubstr("turning_radius"));
  EXPECT_TRUE(make_planner("hybrid_astar", space,
                           {{"turning_radius", "0"}, {"motion_model", "differential"}}));
}

TEST(HybridAStarLimits, GiveThePathThatThereIs) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(60, 60, CellState::free)),
                                           {.footprint = Footprint::disc(1)});
  Query query{{5.5, 5.5, 0}, {Goal(Pose{50.5, 40.5, kPi / 2})}};
  query.limits.expansions = 2;
  const auto plan = planner_on(space)->plan(query);
  ASSERT_TRUE(plan);
  EXPECT_LE(plan->metrics.expanded, 2U);
}

}  // namespace
}  // namespace wend
