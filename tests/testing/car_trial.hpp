#pragma once

// What the tests of driving planners are made of: trials on random yards, queries for a car, and the
// truth about them, which a reference knows.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "conformance/random_yard.hpp"
#include "conformance/trial.hpp"
#include "tests/testing/car_reference.hpp"

namespace wend::test {

/// As random_trial(), for a car: the unit is one that the map may have room for.
inline Trial random_car_trial(std::uint64_t seed, const PlannerInfo& info) {
  Random random(seed);
  GridMap map = random_yard(random);
  OptionValues options = random_options(random, info.options);
  const int unit = one_of<int>(random, std::array{1, 1, 1, 2, 3});
  options.erase(std::remove_if(options.begin(), options.end(),
                               [](const auto& option) {
                                 return option.first == "lattice_resolution" ||
                                        option.first == "turning_radius";
                               }),
                options.end());
  if (unit > 1) options.emplace_back("lattice_resolution", std::to_string(unit));
  const FreeSpaceOptions robot = random_car(random, map.frame().resolution, unit);
  return {std::move(map), robot, std::move(options)};
}

inline CarRules rules_of(const Trial& trial, const PlannerInfo& info) {
  const auto value = [&](const std::string& name) {
    return value_of(name, trial.options, info.options);
  };
  return {.unit = std::stoi(value("lattice_resolution")),
          .straight_terrain = value("straight_terrain"),
          .reverse_factor = std::stod(value("reverse_factor"))};
}

inline bool has_room(const Trial& trial, const CarRules& rules) {
  return rules.unit <= std::min(trial.map.width(), trial.map.height());
}

inline CarReference car_reference_for(const Trial& trial, const PlannerInfo& info) {
  return CarReference(trial.map, robot_in_cells(trial.robot, trial.map.frame()),
                      rules_of(trial, info));
}

/// A stand that is mostly passable.
inline Stand random_stand(Random& random, const CarReference& reference) {
  Stand stand;
  for (int tries = random.chance(0.9) ? 10 : 1; tries > 0; --tries) {
    stand = {random_cell(random, reference.columns(), reference.rows()), random.between(0, 3)};
    if (reference.passable(stand.corner)) break;
  }
  return stand;
}

/// Around a random stand, sometimes exactly on it, seldom off the map; headings beyond a full turn.
inline Pose random_pose(Random& random, const CarReference& reference) {
  Pose pose = reference.pose(random_stand(random, reference));
  const GridMap& map = reference.map();
  if (random.chance(0.5)) {
    const auto off = [&] { return 0.9 * (random.uniform() - 0.5); };
    pose.x = std::clamp<double>(pose.x + off() * reference.rules().unit, 0, map.width());
    pose.y = std::clamp<double>(pose.y + off() * reference.rules().unit, 0, map.height());
    pose.heading += off() * std::numbers::pi / 2 + random.between(-3, 3) * 2 * std::numbers::pi;
  }
  if (random.chance(0.02)) pose.x = random.chance(0.5) ? -0.01 : map.width() + 0.01;
  if (random.chance(0.02)) pose.y = random.chance(0.5) ? -0.01 : map.height() + 0.01;
  return pose;
}

inline Query random_drive(Random& random, const CarReference& reference) {
  Query query{random_pose(random, reference), {}};
  for (int count = random.chance(0.8) ? 1 : random.between(2, 4); count > 0; --count) {
    query.goals.emplace_back(random_pose(random, reference));
    Goal& goal = query.goals.back();
    if (random.chance(0.25)) goal.heading.reset();
    goal.tolerance = random_tolerance(random);
    if (random.chance(0.2)) goal.heading_tolerance = random.between(0, 4) * std::numbers::pi / 4;
  }
  return query;
}

/// The stands that a goal can be reached at, of all on the map: none off the map without a tolerance.
inline std::vector<Stand> stands_of(const Goal& goal, const CarReference& reference) {
  std::vector<Stand> stands;
  const double heading = goal.heading.value_or(0);
  const auto nearest = reference.nearest({goal.point.x, goal.point.y, heading});
  const int nearest_quarter = reference.nearest({0, 0, heading})->quarter;
  for (int x = 0; x < reference.columns(); ++x) {
    for (int y = 0; y < reference.rows(); ++y) {
      for (int quarter = 0; quarter < 4; ++quarter) {
        const Stand stand{{x, y}, quarter};
        const Pose pose = reference.pose(stand);
        const double away = std::hypot(pose.x - goal.point.x, pose.y - goal.point.y);
        const double turn = std::abs(std::remainder(pose.heading - heading, 2 * std::numbers::pi));
        const bool here = (nearest && nearest->corner == stand.corner) ||
                          (goal.tolerance > 0 && away < goal.tolerance + 1e-6);
        const bool faced = !goal.heading || quarter == nearest_quarter ||
                           (goal.heading_tolerance > 0 && turn < goal.heading_tolerance + 1e-6);
        if (here && faced) stands.push_back(stand);
      }
    }
  }
  return stands;
}

/// What the reference says of a drive.
struct CarTruth {
  std::vector<Status> failures;  // without a path: the reason for each goal
  double fuel = kInfinite;
};

inline CarTruth truth_of(const CarReference& reference, const Query& query) {
  const auto start = reference.nearest(query.start);
  if (!start) return {{Status::start_outside}};
  if (!reference.passable(start->corner)) return {{Status::start_blocked}};
  const std::vector<double> fuel = reference.fuel_from(*start);
  CarTruth truth;
  for (const Goal& goal : query.goals) {
    const std::vector<Stand> stands = stands_of(goal, reference);
    const bool passable = std::ranges::any_of(
        stands, [&](const Stand& stand) { return reference.passable(stand.corner); });
    truth.failures.push_back(stands.empty() ? Status::goal_outside
                             : passable     ? Status::unreachable
                                            : Status::goal_blocked);
    for (const Stand& stand : stands) {
      truth.fuel = std::min(truth.fuel, fuel[reference.number(stand)]);
    }
  }
  if (truth.fuel < kInfinite) truth.failures.clear();
  return truth;
}

}  // namespace wend::test
