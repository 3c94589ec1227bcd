// What must not matter to a car: which way a yard is turned or mirrored, which way its rows are
// counted, and, where reversing costs as much as driving ahead, the direction of time.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "conformance/answer.hpp"
#include "conformance/random_map.hpp"
#include "tests/testing/car_simulator.hpp"
#include "tests/testing/car_trial.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kSymmetryRelative = 1e-9;
constexpr double kPi = std::numbers::pi;
constexpr int kSymmetryYards = test::share_of(400);

/// A symmetry of the square: first mirrored at the diagonal, then along x and y.
struct Symmetry {
  bool transposed;
  bool x_mirrored;
  bool y_mirrored;

  Cell size(const GridMap& map) const {
    return transposed ? Cell{map.height(), map.width()} : Cell{map.width(), map.height()};
  }

  /// Where a point of a map comes to lie.
  Point of(Point point, const GridMap& map) const {
    if (transposed) std::swap(point.x, point.y);
    if (x_mirrored) point.x = size(map).x - point.x;
    if (y_mirrored) point.y = size(map).y - point.y;
    return point;
  }

  double of(double heading) const {
    if (transposed) heading = kPi / 2 - heading;
    if (x_mirrored) heading = kPi - heading;
    if (y_mirrored) heading = -heading;
    return heading;
  }

  Pose of(const Pose& pose, const GridMap& map) const {
    const Point point = of(pose.point(), map);
    return {point.x, point.y, of(pose.heading)};
  }

  Query of(const Query& query, const GridMap& map) const {
    Query other{of(query.start, map), {}};
    for (Goal goal : query.goals) {
      goal.point = of(goal.point, map);
      if (goal.heading) goal.heading = of(*goal.heading);
      other.goals.push_back(goal);
    }
    return other;
  }

  GridMap of(const GridMap& map) const {
    const Cell last = size(map);
    Grid<CellState> states(last.x, last.y);
    Grid<double> terrain(last.x, last.y);
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const Point centre = of(centre_of({x, y}), map);
        const Cell to{static_cast<int>(centre.x), static_cast<int>(centre.y)};
        states[to] = map.state({x, y});
        terrain[to] = map.terrain({x, y});
      }
    }
    return *make_grid_map(states, map.frame(), terrain);
  }
};

constexpr std::array<Symmetry, 8> kSymmetries{{{false, false, false},
                                               {false, true, false},
                                               {false, false, true},
                                               {false, true, true},
                                               {true, false, false},
                                               {true, true, false},
                                               {true, false, true},
                                               {true, true, true}}};

class CarSymmetry : public ::testing::TestWithParam<std::string> {
 protected:
  const PlannerInfo& info() const { return *planners().find(GetParam()); }

  std::unique_ptr<Planner> make(const Trial& trial) const {
    return info().make(*make_free_space(trial.map, trial.robot), trial.options).value();
  }

  /// Trials on which a mirrored lattice is a lattice: the unit divides the map's size.
  template <class Check>
  void on_random_yards(Check&& check) {
    int checked = 0;
    for (std::uint64_t seed = 1; seed <= kSymmetryYards && !HasFailure(); ++seed) {
      const Trial trial = random_car_trial(seed, info());
      const int unit = rules_of(trial, info()).unit;
      if (trial.map.width() % unit != 0 || trial.map.height() % unit != 0) continue;
      SCOPED_TRACE(text_of(trial, seed));
      const CarReference reference = car_reference_for(trial, info());
      Random random(seed);
      const Query query = random_drive(random, reference);
      SCOPED_TRACE(text_of(query));
      check(trial, reference, query);
      ++checked;
    }
    EXPECT_GT(checked, kSymmetryYards / 2) << "too few to say anything";
  }
};

TEST_P(CarSymmetry, YardsThatAreTurnedOrMirroredCostTheSame) {
  on_random_yards([&](const Trial& trial, const CarReference&, const Query& query) {
    const Answer answer = answer_of(*make(trial), query);
    for (const Symmetry& symmetry : kSymmetries) {
      const Trial other{symmetry.of(trial.map), trial.robot, trial.options};
      const Answer mirrored = answer_of(*make(other), symmetry.of(query, trial.map));
      ASSERT_EQ(to_string(mirrored.status), to_string(answer.status));
      if (answer.status != Status::found || !answer.plan.optimal()) continue;
      ASSERT_NEAR(mirrored.plan.cost, answer.plan.cost, kSymmetryRelative * answer.plan.cost)
          << symmetry.transposed << symmetry.x_mirrored << symmetry.y_mirrored;
    }
  });
}

/// Right is left where the same rows are seen from the other end.
std::string_view name_from_below(std::string_view move) {
  for (const auto& [right, left] :
       {std::pair<std::string_view, std::string_view>{"FWD_RIGHT", "FWD_LEFT"},
        {"REV_RIGHT", "REV_LEFT"}}) {
    if (move == right) return left;
    if (move == left) return right;
  }
  return move;
}

TEST_P(CarSymmetry, TheSameGridGivesTheSameSearchWithYUpAndYDown) {
  on_random_yards([&](const Trial& trial, const CarReference&, const Query& query) {
    Answer expected = answer_of(*make(trial), query);
    for (std::string_view& move : expected.plan.moves) move = name_from_below(move);
    Frame frame = trial.map.frame();
    frame.y_up = !frame.y_up;
    const Trial other{test::in_frame(trial.map, frame), trial.robot, trial.options};
    EXPECT_EQ(answer_of(*make(other), query), expected);
  });
}

std::string_view undone(std::string_view move) {
  constexpr std::array<std::string_view, 3> kEnds{"", "_RIGHT", "_LEFT"};
  for (const std::string_view end : kEnds) {
    for (const Maneuver& maneuver : kManeuvers) {
      const bool ahead = maneuver.gear > 0;
      if (move != (ahead ? "FWD" : "REV") + std::string(end)) continue;
      for (const Maneuver& other : kManeuvers) {
        if (other.name == (ahead ? "REV" : "FWD") + std::string(end)) return other.name;
      }
    }
  }
  return {};
}

/// The same poses the other way round, by the moves that undo them.
Plan reversed_in_time(const Plan& plan) {
  Plan reversed = plan;
  reversed.path.reverse();
  std::reverse(reversed.moves.begin(), reversed.moves.end());
  for (std::string_view& move : reversed.moves) move = undone(move);
  return reversed;
}

TEST_P(CarSymmetry, ADriveReversedInTimeIsADriveOfTheSameCost) {
  int driven = 0;
  on_random_yards([&](const Trial& drawn, const CarReference&, const Query& query) {
    Trial trial{drawn.map, drawn.robot, drawn.options};
    trial.options.emplace_back("reverse_factor", "1");
    const CarReference reference = car_reference_for(trial, info());
    const auto planner = make(trial);
    const Answer answer = answer_of(*planner, query);
    if (answer.status != Status::found) return;
    EXPECT_EQ(fault_of(reversed_in_time(answer.plan), reference), "");
    const std::vector<Pose> poses = answer.plan.path.poses();
    const Answer back = answer_of(*planner, {poses.back(), {poses.front()}});
    ASSERT_EQ(to_string(back.status), to_string(Status::found));
    if (answer.plan.optimal()) {
      EXPECT_NEAR(back.plan.cost, answer.plan.cost, kSymmetryRelative * answer.plan.cost);
    }
    driven += poses.size() > 2 ? 1 : 0;
  });
  EXPECT_GT(driven, kSymmetryYards / 20) << "too few drives to say anything";
}

INSTANTIATE_TEST_SUITE_P(Registry, CarSymmetry, ::testing::ValuesIn(planner_names("car")),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
