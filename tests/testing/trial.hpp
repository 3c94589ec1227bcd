#pragma once

// What the tests of planners are made of: trials (a map, a robot, options), test_queries (from where to
// where) and the truth about them, which a reference knows.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/testing/random_map.hpp"
#include "tests/testing/random_options.hpp"
#include "tests/testing/reference.hpp"
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
  GridMap map = random_map(random);
  const FreeSpaceOptions robot = random_robot(random, map.frame().resolution);
  return {map, robot, random_options(random, info.options)};
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
  return Reference(trial.map, robot_in_cells(trial.robot, trial.map.frame()), rules);
}

/// Where a planner goes from and to in a test: cells that are mostly passable.
struct TestQuery {
  Cell start;
  std::vector<Cell> goals;

  Query query() const {
    Query query{pose_at(start), {}};
    for (const Cell goal : goals) query.goals.push_back(pose_at(goal));
    return query;
  }
};

inline std::string text_of(const TestQuery& test_query) {
  std::ostringstream text;
  text << "(" << test_query.start.x << "," << test_query.start.y << ") to";
  for (const Cell goal : test_query.goals) text << " (" << goal.x << "," << goal.y << ")";
  return text.str();
}

inline TestQuery random_test_query(Random& random, const GridMap& map) {
  TestQuery test_query{random_cell_or_outside(random, map.width(), map.height()), {}};
  for (int count = random.chance(0.8) ? 1 : random.between(2, 4); count > 0; --count) {
    test_query.goals.push_back(random_cell_or_outside(random, map.width(), map.height()));
  }
  return test_query;
}

/// What the reference says of an test_query.
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
  for (const Cell goal : test_query.goals) {
    if (!map.contains(goal)) {
      truth.failures.push_back(Status::goal_outside);
      continue;
    }
    truth.failures.push_back(reference.passable(goal) ? Status::unreachable : Status::goal_blocked);
    truth.cost = std::min(truth.cost, costs[reference.number(goal)]);
    truth.steps = std::min(truth.steps, steps[reference.number(goal)]);
  }
  if (truth.cost < kInfinite) truth.failures.clear();
  return truth;
}

}  // namespace wend::test
