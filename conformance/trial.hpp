#pragma once

// What the checks of planners are made of: trials (a map, a robot, options), queries (from where to
// where) and the truth about them, which a reference knows.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/random_options.hpp"
#include "conformance/random_yard.hpp"
#include "conformance/reference.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend::test {

/// A map, a robot and options for a planner, all from one seed.
struct Trial {
  GridMap map;
  FreeSpaceOptions robot;
  OptionValues options;
};

inline Trial random_trial(std::uint64_t seed, const PlannerInfo& info) {
  Random random(seed);
  const GridMap map = random_map(random);
  const FreeSpaceOptions robot = random_robot(random, map.frame().resolution);
  return {map, robot, random_options(random, info.options)};
}

/// A box around the base point that is longer ahead; as large as a few cells.
inline Footprint random_box(Random& random, double resolution) {
  const double ahead = (0.2 + random.uniform()) * resolution;
  const double behind = (0.1 + 0.6 * random.uniform()) * resolution;
  const double side = (0.1 + 0.4 * random.uniform()) * resolution;
  return *Footprint::polygon(
      *Polygon::make({{ahead, side}, {-behind, side}, {-behind, -side}, {ahead, -side}}));
}

/// As random_trial(), for a planner whose states have headings: a map with more room, and options that
/// do not change lengths, because most of those have no room on a small map.
inline Trial random_pose_trial(std::uint64_t seed, const PlannerInfo& info) {
  Random random(seed);
  GridMap map = random_yard(random);
  OptionValues options = random_options(random, info.options);
  std::erase_if(options, [](const auto& option) {
    return option.first.find("radius") != std::string::npos ||
           option.first.find("resolution") != std::string::npos;
  });
  const double resolution = map.frame().resolution;
  FreeSpaceOptions robot = random_car(random, resolution, 1);
  if (info.capabilities.primitives && random.chance(0.3)) {
    robot.footprint = random_box(random, resolution);
  }
  return {std::move(map), robot, std::move(options)};
}

inline std::string text_of(const Trial& trial, std::uint64_t seed) {
  std::ostringstream text;
  text << "seed " << seed << ", radius " << trial.robot.footprint.circumscribed_radius()
       << " m, resolution " << trial.map.frame().resolution
       << (trial.map.uniform_terrain() ? "" : ", terrain")
       << (trial.robot.unknown == UnknownPolicy::free ? ", enters unknown" : "")
       << (robot_in_cells(trial.robot, trial.map.frame()).stays_on_map ? ", stays on the map" : "")
       << ", keeps away " << trial.robot.clearance_distance << " m at "
       << trial.robot.clearance_cost << ", options: " << test::text_of(trial.options) << '\n'
       << drawing_of(trial.map);
  return text.str();
}

/// The rules that a planner with these options moves by; 8 neighbours where it has no such option.
inline Reference reference_for(const Trial& trial, const PlannerInfo& info) {
  const std::string corners = value_of("corner_rule", trial.options, info.options);
  const Rules rules{.diagonals = value_of("connectivity", trial.options, info.options) != "4",
                    .corners_cut = corners == "both"  ? 2
                                   : corners == "one" ? 1
                                                      : 0};
  return {trial.map, robot_in_cells(trial.robot, trial.map.frame()), rules};
}

/// Where a path may end: in the cell of a point, or near it.
struct TestGoal {
  Point point;
  double tolerance = 0;

  /// The middle of a cell.
  // NOLINTNEXTLINE(google-explicit-constructor): a cell is a goal
  TestGoal(Cell cell) : point(centre_of(cell)) {}

  /// By brute force, in one pass over the map.
  std::vector<Cell> ends(const GridMap& map) const {
    std::vector<Cell> ends;
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const double away = std::hypot(x + 0.5 - point.x, y + 0.5 - point.y);
        const bool holds_it =
            x <= point.x && point.x < x + 1.0 && y <= point.y && point.y < y + 1.0;
        if (holds_it || (tolerance > 0 && away < tolerance + 1e-6)) ends.push_back({x, y});
      }
    }
    return ends;
  }
};

/// Where a planner goes from and to in a test: cells that are mostly passable.
struct TestQuery {
  Cell start;
  std::vector<TestGoal> goals;

  Query query() const {
    Query query{pose_at(start), {}};
    for (const TestGoal& goal : goals) {
      query.goals.emplace_back(Pose{goal.point.x, goal.point.y}, goal.tolerance);
    }
    return query;
  }

  /// The cells of the map in which a path may end; of a goal without any, the cell of its point.
  std::vector<Cell> ends(const GridMap& map) const {
    std::vector<Cell> all;
    for (const TestGoal& goal : goals) {
      const std::vector<Cell> ends = goal.ends(map);
      all.insert(all.end(), ends.begin(), ends.end());
      if (ends.empty()) all.push_back(cell_at(goal.point));
    }
    return all;
  }
};

inline std::string text_of(const TestQuery& test_query) {
  std::ostringstream text;
  text << "(" << test_query.start.x << "," << test_query.start.y << ") to";
  for (const TestGoal& goal : test_query.goals) {
    text << " (" << goal.point.x << "," << goal.point.y << ")";
    if (goal.tolerance > 0) text << " within " << goal.tolerance;
  }
  return text.str();
}

/// Mostly none; among the others are those that reach centres of cells exactly.
inline double random_tolerance(Random& random) {
  if (!random.chance(0.25)) return 0;
  return random.chance(0.5) ? random.between(1, 4) : 5 * random.uniform();
}

inline TestQuery random_test_query(Random& random, const GridMap& map) {
  TestQuery test_query{random_cell_or_outside(random, map.width(), map.height()), {}};
  for (int count = random.chance(0.8) ? 1 : random.between(2, 4); count > 0; --count) {
    test_query.goals.emplace_back(random_cell_or_outside(random, map.width(), map.height()));
    TestGoal& goal = test_query.goals.back();
    goal.tolerance = random_tolerance(random);
    if (goal.tolerance == 0 || random.chance(0.5)) continue;
    constexpr int kParts = 16;  // of a cell: whole units of Visibility
    goal.point.x += random.between(1 - kParts / 2, kParts / 2 - 1) / double{kParts};
    goal.point.y += random.between(1 - kParts / 2, kParts / 2 - 1) / double{kParts};
  }
  return test_query;
}

inline std::string text_of(const Query& query) {
  std::ostringstream text;
  text << "(" << query.start.x << "," << query.start.y << "," << query.start.heading << ") to";
  for (const Goal& goal : query.goals) {
    text << " (" << goal.point.x << "," << goal.point.y << ",";
    if (goal.heading) {
      text << *goal.heading << ")";
    } else {
      text << "any)";
    }
    if (goal.tolerance > 0) text << " within " << goal.tolerance;
    if (goal.heading_tolerance > 0) text << " turned by " << goal.heading_tolerance;
  }
  return text.str();
}

/// From a point that is mostly on the map to some of these; any heading.
inline Query random_pose_query(Random& random, const GridMap& map) {
  const auto pose = [&] {
    Cell cell;
    for (int tries = 0; tries < 5; ++tries) {
      cell = random_cell_or_outside(random, map.width(), map.height());
      if (map.contains(cell) && map.state(cell) == CellState::free) break;
    }
    return Pose{cell.x + random.uniform(), cell.y + random.uniform(), 12 * random.uniform() - 6};
  };
  Query query{pose(), {}};
  for (int count = random.chance(0.7) ? 1 : random.between(2, 4); count > 0; --count) {
    query.goals.emplace_back(pose());
    Goal& goal = query.goals.back();
    if (random.chance(0.3)) goal.heading.reset();
    goal.tolerance = random_tolerance(random);
    if (random.chance(0.2)) goal.heading_tolerance = 4 * random.uniform();
  }
  return query;
}

/// A query for what the planner plans for.
inline Query random_query(Random& random, const GridMap& map, const PlannerInfo& info) {
  if (info.capabilities.headings) return random_pose_query(random, map);
  return random_test_query(random, map).query();
}

/// What the reference says of a query.
struct Truth {
  std::vector<Status> failures;  // if there is no path: the reason, one for each goal
  double cost = kInfinite;       // of the cheapest path to any goal
  double steps = kInfinite;      // of the shortest one
};

inline Truth truth_of(const Reference& reference, const GridMap& map, const TestQuery& test_query) {
  if (!map.contains(test_query.start)) return {{Status::start_outside}};
  if (!reference.passable(test_query.start)) return {{Status::start_blocked}};
  const std::vector<double> costs = reference.costs_from(test_query.start);
  const std::vector<double> steps = reference.steps_from(test_query.start);
  Truth truth;
  for (const TestGoal& goal : test_query.goals) {
    Status failure = Status::goal_outside;
    for (const Cell end : goal.ends(map)) {
      if (failure == Status::goal_outside) failure = Status::goal_blocked;
      if (reference.passable(end)) failure = Status::unreachable;
      truth.cost = std::min(truth.cost, costs[reference.number(end)]);
      truth.steps = std::min(truth.steps, steps[reference.number(end)]);
    }
    truth.failures.push_back(failure);
  }
  if (truth.cost < kInfinite) truth.failures.clear();
  return truth;
}

}  // namespace wend::test
