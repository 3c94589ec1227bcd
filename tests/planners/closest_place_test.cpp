// PlanRequest::closest, PlanRequest::nearest with its limit, and PlanRequest::escape, for every planner: against a flood
// by the planners' rules, and against plans to every single place.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/session/session.hpp"

namespace wend {
namespace {

GridMap random_rooms(Random& random, int width, int height, double share) {
  Grid<CellState> states(width, height, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(share)) states[cell] = CellState::occupied;
  }
  return *make_grid_map(states);
}

std::vector<std::string> planners_on_cells() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    // Where a random walk ends is no property of a planner.
    if (!info.capabilities.headings && info.name != "random_walk") names.push_back(info.name);
  }
  return names;
}

/// The cells that moves lead to from a cell. Diagonal ones pass no corner.
BitGrid flooded(const FreeSpace& space, Cell start) {
  BitGrid reached(space.width(), space.height());
  if (!space.passable(start)) return reached;
  reached.set(start, true);
  std::deque<Cell> open{start};
  while (!open.empty()) {
    const Cell cell = open.front();
    open.pop_front();
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{cell.x + dx, cell.y + dy};
        if (!space.passable(next) || reached[next]) continue;
        if (!space.passable({cell.x, next.y}) || !space.passable({next.x, cell.y})) continue;
        reached.set(next, true);
        open.push_back(next);
      }
    }
  }
  return reached;
}

double least_distance(const BitGrid& cells, const std::vector<MapGoal>& goals) {
  double least = HUGE_VAL;
  for (const Cell cell : every_cell(cells)) {
    if (!cells[cell]) continue;
    for (const MapGoal& goal : goals) {
      least = std::min(least, std::hypot(cell.x + 0.5 - goal.point.x, cell.y + 0.5 - goal.point.y));
    }
  }
  return least;
}

class ClosestCell : public ::testing::TestWithParam<std::string> {};

TEST_P(ClosestCell, IsTheNearestThatAFloodReachesAndTheCheapestOfThose) {
  int eased = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(60U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Session session(random_rooms(random, random.between(2, 16), random.between(2, 12), 0.4),
                    {.footprint = Footprint::disc(random.chance(0.8) ? 0 : 0.8)});
    if (planners().find(GetParam())->index_support) {
      ASSERT_TRUE(session.build_index(GetParam()));
    }
    const FreeSpace space = session.view()->space;
    PlanRequest request;
    request.planner = {GetParam()};
    request.closest = true;
    request.start = {std::floor(space.width() * random.uniform()) + 0.5,
                     std::floor(space.height() * random.uniform()) + 0.5, 0};
    for (int i = random.between(1, 3); i > 0; --i) {
      // The ends of planners on cells are cells where a map has no metres.
      request.goals.push_back({{std::floor(1.4 * space.width() * random.uniform() - 2) + 0.5,
                                std::floor(1.4 * space.height() * random.uniform() - 2) + 0.5}});
    }
    const auto answer = session.plan(request);
    const BitGrid reached = flooded(space, cell_at({request.start.x, request.start.y}));
    if (reached.count() == 0) {
      EXPECT_FALSE(answer);
      continue;
    }
    if (!answer && answer.error().status == Status::unsupported_map) return;
    ASSERT_TRUE(answer) << answer.error().message;
    const bool reaches = std::ranges::any_of(request.goals, [&](const MapGoal& goal) {
      const auto cell = cell_under(space, {goal.point.x, goal.point.y});
      return cell && reached[*cell];
    });
    ASSERT_TRUE(answer->remaining);
    if (reaches) {
      EXPECT_EQ(answer->remaining, 0);
      EXPECT_TRUE(answer->notes.empty());
      continue;
    }
    ++eased;
    const double least = least_distance(reached, request.goals);
    EXPECT_NEAR(*answer->remaining, least, 1e-9);
    EXPECT_EQ(answer->notes.size(), 1U);
    const Point end = answer->path().points().back();
    double from_goal = HUGE_VAL;
    for (const MapGoal& goal : request.goals) {
      from_goal = std::min(from_goal, std::hypot(end.x - goal.point.x, end.y - goal.point.y));
    }
    EXPECT_NEAR(from_goal, least, 1e-9);
    if (!answer->plan.optimal()) continue;
    PlanRequest each = request;
    each.closest = false;
    double cheapest = HUGE_VAL;
    for (const Cell cell : every_cell(reached)) {
      if (!reached[cell]) continue;
      each.goals = {{{cell.x + 0.5, cell.y + 0.5}}};
      double away = HUGE_VAL;
      for (const MapGoal& goal : request.goals) {
        away = std::min(away, std::hypot(cell.x + 0.5 - goal.point.x, cell.y + 0.5 - goal.point.y));
      }
      if (away > least + 1e-9) continue;
      cheapest = std::min(cheapest, session.plan(each)->plan.cost);
    }
    EXPECT_NEAR(answer->plan.cost, cheapest, 1e-9);
  }
  EXPECT_GT(eased, test::share_of(5));
}

INSTANTIATE_TEST_SUITE_P(Planners, ClosestCell, ::testing::ValuesIn(planners_on_cells()),
                         [](const auto& info) { return info.param; });

struct Driver {
  std::string planner;
  OptionValues options;
  double precision;  // cells
};

class ClosestPose : public ::testing::TestWithParam<Driver> {};

TEST_P(ClosestPose, IsTheNearestThatPlansToEveryPlaceReach) {
  const Driver& driver = GetParam();
  const bool corners = planners().find(driver.planner)->capabilities.vertices == Vertices::corners;
  int eased = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(25U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Session session(random_rooms(random, 11, 9, 0.25));
    PlanRequest request;
    request.planner = {driver.planner, driver.options};
    request.closest = true;
    request.start = {4 + (corners ? 0 : 0.5), 4 + (corners ? 0 : 0.5), 0};
    request.goals = {{{13 * random.uniform() - 1, 11 * random.uniform() - 1},
                      random.chance(0.5) ? std::optional(1.0) : std::nullopt}};
    const auto answer = session.plan(request);
    PlanRequest each = request;
    each.closest = false;
    each.explain = false;
    if (session.plan(each)) {
      ASSERT_TRUE(answer) << answer.error().message;
      EXPECT_EQ(answer->remaining, 0);
      continue;
    }
    const MapPoint goal = request.goals.front().point;
    std::vector<std::pair<double, MapPoint>> places;
    for (int y = 0; y < (corners ? 10 : 9); ++y) {
      for (int x = 0; x < (corners ? 12 : 11); ++x) {
        const MapPoint place{x + (corners ? 0 : 0.5), y + (corners ? 0 : 0.5)};
        places.emplace_back(std::hypot(place.x - goal.x, place.y - goal.y), place);
      }
    }
    std::ranges::sort(places, {}, [](const auto& place) { return place.first; });
    const auto nearest = std::ranges::find_if(places, [&](const auto& place) {
      each.goals = {{place.second}};
      return session.plan(each).has_value();
    });
    const double least = nearest == places.end() ? HUGE_VAL : nearest->first;
    if (least == HUGE_VAL) {
      EXPECT_FALSE(answer);
      continue;
    }
    ASSERT_TRUE(answer) << answer.error().message;
    ++eased;
    EXPECT_LE(*answer->remaining, least + driver.precision);
    if (driver.precision < 0.1) {
      EXPECT_GE(*answer->remaining, least - 1e-9);
    }
  }
  EXPECT_GE(eased, test::share_of(3));
}

INSTANTIATE_TEST_SUITE_P(
    Planners, ClosestPose,
    ::testing::Values(Driver{"lattice", {}, 0.03}, Driver{"car", {}, 0.03},
                      Driver{"hybrid_astar", {{"motion_model", "differential"}}, 0.6}),
    [](const auto& info) { return info.param.planner; });

/// A keep-out zone of a mask on the left, and a room of its own on the right.
GridMap zone_map() {
  GridMap map = test::drawn_map(
      "....................\n"
      "....................\n"
      "....................\n"
      "....................\n"
      "............#####...\n"
      "............#...#...\n"
      "............#...#...\n"
      "............#####...\n"
      "....................\n");
  BitGrid zone(20, 9);
  BitGrid occupied = map.occupied();
  for (int y = 2; y < 7; ++y) {
    for (int x = 1; x < 5; ++x) {
      zone.set({x, y}, true);
      occupied.set({x, y}, true);
    }
  }
  map = *make_grid_map(occupied, map.unknown(), map.frame());
  map.add_zone({"depot.yaml", zone});
  return map;
}

std::vector<std::string> all_planners() {
  std::vector<std::string> names = planners_on_cells();
  for (const PlannerInfo& info : planners()) {
    if (info.capabilities.headings) names.push_back(info.name);
  }
  return names;
}

class Escape : public ::testing::TestWithParam<std::string> {};

TEST_P(Escape, BeginsWithTheWayOutAndGoesOnAsPlanned) {
  const PlannerInfo& info = *planners().find(GetParam());
  for (const double radius : {0.0, 0.7}) {
    SCOPED_TRACE(radius);
    Session session(zone_map(), {.footprint = Footprint::disc(radius)});
    if (info.index_support) {
      ASSERT_TRUE(session.build_index(info.name));
    }
    PlanRequest request;
    request.planner = {info.name};
    if (info.name == "hybrid_astar") request.planner.options = {{"turning_radius", "1"}};
    const double off = info.capabilities.vertices == Vertices::corners ? 0 : 0.5;
    request.start = {3 + off, 4 + off, 0};
    request.goals = {{{10 + off, 1 + off}}};
    const auto refused = session.plan(request);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Status::start_blocked);
    EXPECT_NE(refused.error().message.find("the keep-out mask 'depot.yaml'"), std::string::npos)
        << refused.error().message;
    request.escape = 4;
    const auto answer = session.plan(request);
    if (!answer && answer.error().status == Status::unsupported_map) continue;
    ASSERT_TRUE(answer) << answer.error().message;
    ASSERT_TRUE(answer->lead_out);
    EXPECT_EQ(answer->notes.size(), 1U);
    EXPECT_NEAR(answer->lead_out->length, radius == 0 ? 2 : 3, 1.01);
    EXPECT_EQ(answer->path().points().front(), (Point{request.start.x, request.start.y}));
    EXPECT_NEAR(distance(answer->path().points().back(), {10 + off, 1 + off}), 0, 1e-6);
    const FreeSpace space = session.view()->space;
    const Path lead = lead_of(answer->path(), answer->lead_out->points);
    EXPECT_NEAR(lead.length(), answer->lead_out->length, 1e-6);
    const Path rest = behind_lead(answer->path(), answer->lead_out->points);
    EXPECT_FALSE(first_collision(rest, space));
    EXPECT_FALSE(check_with_lead(answer->path(), space, answer->lead_out->length).collision);
    request.start = {rest.poses().front().x, rest.poses().front().y, rest.poses().front().heading};
    const auto from_there = session.plan(request);
    ASSERT_TRUE(from_there);
    EXPECT_FALSE(from_there->lead_out);
    if (info.name != "random_walk") {
      EXPECT_NEAR(from_there->plan.cost, answer->plan.cost, 1e-9);
    }
    request.start = {3 + off, 4 + off, 0};
    request.escape = 0.5;
    EXPECT_EQ(session.plan(request).error().status, Status::start_blocked);
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, Escape, ::testing::ValuesIn(all_planners()),
                         [](const auto& info) { return info.param; });

TEST(EasedSession, RefinesAndTimesOnlyWhatIsBehindTheWayOut) {
  Session session(zone_map());
  PlanRequest request;
  request.start = {3.5, 4.5, 0};
  request.goals = {{{10.5, 7.5}}};
  request.escape = 3;
  request.refinement.smoother = SmootherChoice{};
  request.trajectory = TrajectoryLimits{};
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_FALSE(answer->fault) << answer->fault->message;
  ASSERT_TRUE(answer->refined && answer->trajectory && answer->lead_out);
  const std::size_t points = answer->lead_out->points;
  EXPECT_EQ(lead_of(answer->refined->path, points).points(),
            lead_of(answer->plan.path, points).points());
  EXPECT_FALSE(first_collision(behind_lead(answer->refined->path, points), session.view()->space));
}

TEST(EasedSession, AnswersFromAFieldToo) {
  Session session(zone_map());
  PlanRequest request;
  request.start = {3.5, 4.5, 0};
  request.goals = {{{14.5, 5.5}}};
  request.escape = 3;
  request.closest = true;
  request.from_field = true;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_TRUE(answer->lead_out);
  EXPECT_NEAR(answer->remaining.value(), 2, 1e-9);
  EXPECT_EQ(answer->notes.size(), 2U);
}

TEST(EasedSession, SaysHowFarTheWayOutIs) {
  PlanRequest request;
  request.start = {3.5, 4.5, 0};
  request.goals = {{{10.5, 1.5}}};
  const auto message = [&](double escape) {
    Session hinted(zone_map(), {}, {.hints = {.escape = "--escape"}});
    request.escape = escape;
    return hinted.plan(request).error().message;
  };
  EXPECT_NE(message(0).find("the cell is blocked by the keep-out mask 'depot.yaml'"),
            std::string::npos)
      << message(0);
  EXPECT_NE(message(0).find("--escape 2 lets the robot leave it"), std::string::npos) << message(0);
  EXPECT_NE(message(0.5).find("longer than the 0.5 cells allowed"), std::string::npos)
      << message(0.5);
}

TEST(EasedSession, MovesEndsNoFartherThanTheLimit) {
  const auto plan = [](bool metric, std::optional<double> limit, MapGoal goal) {
    GridMap map = zone_map();
    Frame frame = map.frame();
    frame.metric = metric;
    map = *make_grid_map(map.occupied(), map.unknown(), frame);
    Session session(map);
    PlanRequest request;
    request.start = {7.5, 1.5, 0};
    request.goals = {goal};
    request.nearest = true;
    request.nearest_limit = limit;
    return session.plan(request);
  };
  const MapGoal in_zone{{3.5, 4.5}};
  const MapGoal walled_in{{14.5, 5.5}};
  for (const MapGoal& goal : {in_zone, walled_in}) {
    EXPECT_TRUE(plan(false, {}, goal)) << "any distance on a map in cells";
    EXPECT_TRUE(plan(true, 2, goal));
    EXPECT_FALSE(plan(true, 1.9, goal));
    const auto usual = plan(true, {}, goal);
    ASSERT_FALSE(usual);
    EXPECT_NE(usual.error().message.find("2 m away, more than the limit of 1 m"), std::string::npos)
        << usual.error().message;
  }
  EXPECT_NEAR(plan(true, 2, walled_in)->remaining.value(), 2, 1e-9);
  EXPECT_EQ(plan(true, 2, walled_in)->notes.size(), 1U);
}

TEST(EasedSession, RefusesLengthsThatAreNone) {
  Session session(zone_map());
  PlanRequest request;
  request.start = {7.5, 1.5, 0};
  request.goals = {{{10.5, 1.5}}};
  for (const double wrong : {-1.0, std::nan(""), HUGE_VAL}) {
    request.escape = wrong;
    EXPECT_EQ(session.plan(request).error().status, Status::invalid_option) << wrong;
  }
  request.escape = 0;
  request.nearest_limit = -1;
  EXPECT_EQ(session.plan(request).error().status, Status::invalid_option);
}

}  // namespace
}  // namespace wend
