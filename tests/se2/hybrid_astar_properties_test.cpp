// What is true of hybrid_astar on any map: its paths are free by brute force; they can be driven back; a turned map
// and a larger robot that fits all the same change little.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/driven_path.hpp"
#include "conformance/random_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kYardRadius = 3;     // cells
constexpr double kReverseFactor = 2;  // its default
constexpr double kTurnFactor = 1.2;   // its default

constexpr std::string_view kDisc = "disc:1.1";
constexpr std::string_view kPlainBox = "1.5,0.8; -1,0.8; -1,-0.8; 1.5,-0.8";
/// Like an open wrench: a square between its jaws does not touch it.
constexpr std::string_view kWrench =
    "2.2,1.1; 0.4,1.1; -1,0.4; -1,-0.4; 0.4,-1.1; 2.2,-1.1; 2.2,-0.6; 1,-0.55; 1,0.55; 2.2,0.6";
/// The forks of a forklift whose base point is behind them.
constexpr std::string_view kForks = "3.2,0.8; 0.7,0.8; 0.7,-0.8; 3.2,-0.8";

/// Single obstacles, some unknown cells, some walls with gaps.
GridMap random_ground(Random& random, bool walls) {
  const int width = random.between(14, 40);
  const int height = random.between(14, 40);
  Grid<CellState> states(width, height, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (!random.chance(0.015)) continue;
    states[cell] = random.chance(0.2) ? CellState::unknown : CellState::occupied;
  }
  for (int wall = walls ? random.between(0, 2) : 0; wall > 0; --wall) {
    const Cell at = random_cell(random, width, height);
    const bool upright = random.chance(0.5);
    const int length = upright ? height : width;
    const int gap = random.between(0, length - 1);
    for (int i = 0; i < length; ++i) {
      if (std::abs(i - gap) > 2)
        states[upright ? Cell{at.x, i} : Cell{i, at.y}] = CellState::occupied;
    }
  }
  return *make_grid_map(states);
}

/// A pose at which the robot fits, if a few tries find one.
Pose random_pose(Random& random, const FreeSpace& space) {
  constexpr int kTries = 20;
  Pose pose;
  for (int i = 0; i < kTries && (i == 0 || !space.fits(pose)); ++i) {
    pose.x = space.width() * random.uniform();
    pose.y = space.height() * random.uniform();
    pose.heading = normalized_angle(2 * kPi * random.uniform());
  }
  return pose;
}

struct DriveTrial {
  FreeSpace space;
  Pose start;
  Pose goal;

  Query query() const { return {start, {Goal(goal)}}; }
};

DriveTrial random_drive_trial(std::uint64_t seed, std::string_view footprint) {
  Random random(seed);
  const GridMap map = random_ground(random, true);
  const OutsidePolicy outside = random.chance(0.5) ? OutsidePolicy::blocked : OutsidePolicy::free;
  const UnknownPolicy unknown = random.chance(0.5) ? UnknownPolicy::blocked : UnknownPolicy::free;
  FreeSpace space = *make_free_space(
      map, {.footprint = *parse_footprint(footprint), .unknown = unknown, .outside = outside});
  const Pose start = random_pose(random, space);
  const Pose goal = random_pose(random, space);
  return {std::move(space), start, goal};
}

Expected<Plan, PlanFailure> plan_of(const DriveTrial& trial, OptionValues options = {}) {
  options.emplace_back("turning_radius", fmt::format("{}", kYardRadius));
  options.emplace_back("time_budget", "1000");  // on slow machines, too
  return (*make_planner("hybrid_astar", trial.space, options))->plan(trial.query());
}

/// The cost of a path on ground without costs, from its segments alone.
double cost_of_segments(const Path& path, double reverse_factor) {
  double cost = 0;
  for (const Segment& segment : path.segments()) {
    cost += std::abs(segment.length) * (segment.length < 0 ? reverse_factor : 1) *
            (std::abs(segment.turn) > 1e-9 ? kTurnFactor : 1);
  }
  return cost;
}

/// How costs of pairs of queries compare that have the same least cost. hybrid_astar does not promise the least, so
/// single pairs may differ by more than their sums.
class Ratios {
 public:
  void add(std::uint64_t seed, double cost, double other) {
    if (cost == 0 && other == 0) return;
    sum_ += cost;
    others_ += other;
    ++count_;
    const double ratio = std::max(cost / other, other / cost);
    if (ratio > kNear) ++far_;
    if (ratio <= worst_) return;
    worst_ = ratio;
    worst_seed_ = seed;
  }

  /// Notes a pair of which only one has a path: where it is so tight that no path at the search's resolution is sure.
  bool both_found(std::uint64_t seed, bool found, bool other_found) {
    if (found != other_found) lone_.push_back(seed);
    return found && other_found;
  }

  void expect_near(std::uint64_t least_count) const {
    EXPECT_GT(count_, least_count);
    EXPECT_LE(lone_.size(), count_ / 200)
        << fmt::format("one of a pair: {}", fmt::join(lone_, ", "));
    EXPECT_LT(others_ / sum_, kNear);
    EXPECT_LT(sum_ / others_, kNear);
    fmt::print(
        "ratio of the sums {:.4f}; {} of {} pairs differ by more than 3 %; worst {:.3f}, seed {}; "
        "only "
        "one found: {}\n",
        others_ / sum_, far_, count_, worst_, worst_seed_, fmt::join(lone_, ", "));
  }

 private:
  static constexpr double kNear = 1.03;

  double sum_ = 0;
  double others_ = 0;
  double worst_ = 1;
  std::uint64_t worst_seed_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t far_ = 0;
  std::vector<std::uint64_t> lone_;  // seeds
};

/// The shape is placed every fiftieth of a cell, by code that shares nothing with the planner's.
void drive_everywhere(std::string_view footprint, std::uint64_t seeds) {
  std::uint64_t found = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const DriveTrial trial = random_drive_trial(seed, footprint);
    const auto plan = plan_of(trial);
    if (!plan) continue;
    ++found;
    const DriveReport report = checked_drive(trial.space, plan->path, trial.query(),
                                             {.turning_radius = kYardRadius, .step = 0.02});
    EXPECT_EQ(report.fault, "");
    EXPECT_NEAR(plan->cost, cost_of_segments(plan->path, kReverseFactor), 1e-6 * plan->cost);
  }
  EXPECT_GT(found, seeds / 3);
}

/// With equal penalties for both gears, a path driven back costs the same, and is what the reversed query may
/// answer.
void drive_back(std::string_view footprint, std::uint64_t seeds) {
  const OptionValues equal{{"reverse_factor", "1"}};
  Ratios ratios;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const DriveTrial trial = random_drive_trial(seed, footprint);
    const DriveTrial back{trial.space, trial.goal, trial.start};
    const auto plan = plan_of(trial, equal);
    const auto returned = plan_of(back, equal);
    if (!ratios.both_found(seed, plan.has_value(), returned.has_value())) continue;
    Path reversed = plan->path;
    reversed.reverse();
    const DriveReport report =
        checked_drive(back.space, reversed, back.query(), {.turning_radius = kYardRadius});
    EXPECT_EQ(report.fault, "");
    EXPECT_NEAR(cost_of_segments(reversed, 1), plan->cost, 1e-6 * plan->cost);
    ratios.add(seed, plan->cost, returned->cost);
  }
  ratios.expect_near(seeds / 3);
}

/// The map turned by a quarter turn, and the poses with it.
DriveTrial quarter_turned(const DriveTrial& trial) {
  const GridMap& map = trial.space.map();
  Grid<CellState> states(map.height(), map.width(), CellState::free);
  for (const Cell cell : every_cell(states)) {
    states[cell] = map.state({cell.y, map.height() - 1 - cell.x});
  }
  const auto turn = [&](const Pose& pose) {
    return Pose{map.height() - pose.y, pose.x, normalized_angle(pose.heading + kPi / 2)};
  };
  return {*make_free_space(*make_grid_map(states, map.frame()), trial.space.options()),
          turn(trial.start), turn(trial.goal)};
}

void drive_turned(std::string_view footprint, std::uint64_t seeds) {
  Ratios ratios;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const DriveTrial trial = random_drive_trial(seed, footprint);
    const auto plan = plan_of(trial);
    const auto other = plan_of(quarter_turned(trial));
    if (!ratios.both_found(seed, plan.has_value(), other.has_value())) continue;
    ratios.add(seed, plan->cost, other->cost);
  }
  ratios.expect_near(seeds / 3);
}

TEST(LatticePaths, CostExactlyTheSameOnATurnedMap) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < share_of(60U); ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    DriveTrial trial = random_drive_trial(seed, kPlainBox);
    // The lattice has the nearest pose: of two that are equally near, a turned map may take the other.
    trial.start = pose_at(cell_at(trial.start.point()), 0);
    trial.goal = pose_at(cell_at(trial.goal.point()), 0);
    const auto cost_in = [](const DriveTrial& at) -> std::optional<double> {
      const auto planner =
          make_planner("lattice", at.space, {{"turning_radius", fmt::format("{}", kYardRadius)}});
      const auto plan = (*planner)->plan(at.query());
      return plan ? std::optional(plan->cost) : std::nullopt;
    };
    const auto cost = cost_in(trial);
    const auto other = cost_in(quarter_turned(trial));
    ASSERT_EQ(cost.has_value(), other.has_value());
    if (!cost) continue;
    ++found;
    EXPECT_NEAR(*other, *cost, 1e-9 * *cost);
  }
  EXPECT_GT(found, static_cast<int>(share_of(20U)));
}

/// A larger robot that fits along the path of a smaller one has that path, so it pays no more; nor does the smaller
/// one, which fits wherever the larger one does.
void drive_larger(std::string_view footprint, std::uint64_t seeds) {
  Ratios ratios;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const DriveTrial trial = random_drive_trial(seed, footprint);
    const auto plan = plan_of(trial);
    if (!plan) continue;
    FreeSpaceOptions larger = trial.space.options();
    larger.footprint = larger.footprint.scaled(1.06);
    const DriveTrial grown{*make_free_space(trial.space.map(), larger), trial.start, trial.goal};
    if (first_collision(plan->path, grown.space)) continue;
    const auto other = plan_of(grown);
    if (!ratios.both_found(seed, true, other.has_value())) continue;
    ratios.add(seed, plan->cost, other->cost);
  }
  ratios.expect_near(seeds / 3);
}

class HybridAStarPaths : public ::testing::TestWithParam<std::string_view> {
 protected:
  static constexpr std::uint64_t kSome =
      40;  // under the sanitizer, too: sums of few pairs say nothing
  static constexpr std::uint64_t kMany = 2000;
};

TEST_P(HybridAStarPaths, AreFreeByBruteForce) { drive_everywhere(GetParam(), share_of(kSome)); }
TEST_P(HybridAStarPaths, CanBeDrivenBackAtTheSameCost) { drive_back(GetParam(), kSome); }
TEST_P(HybridAStarPaths, CostTheSameOnATurnedMap) { drive_turned(GetParam(), kSome); }
TEST_P(HybridAStarPaths, CostTheSameForALargerRobotThatFits) { drive_larger(GetParam(), kSome); }

TEST_P(HybridAStarPaths, AreFreeByBruteForceInALongRun) { drive_everywhere(GetParam(), kMany); }
TEST_P(HybridAStarPaths, CanBeDrivenBackInALongRun) { drive_back(GetParam(), kMany); }
TEST_P(HybridAStarPaths, CostTheSameOnATurnedMapInALongRun) { drive_turned(GetParam(), kMany); }
TEST_P(HybridAStarPaths, CostTheSameForALargerRobotInALongRun) { drive_larger(GetParam(), kMany); }

/// Whose base point may be above an obstacle.
class HybridAStarForks : public HybridAStarPaths {};

TEST_P(HybridAStarForks, AreFreeByBruteForce) { drive_everywhere(GetParam(), share_of(kSome)); }
TEST_P(HybridAStarForks, CostTheSameOnATurnedMap) { drive_turned(GetParam(), kSome); }
TEST_P(HybridAStarForks, CostTheSameForALargerRobotThatFits) { drive_larger(GetParam(), kSome); }
TEST_P(HybridAStarForks, AreFreeByBruteForceInALongRun) { drive_everywhere(GetParam(), kMany); }

INSTANTIATE_TEST_SUITE_P(Footprints, HybridAStarForks, ::testing::Values(kForks));

INSTANTIATE_TEST_SUITE_P(Footprints, HybridAStarPaths,
                         ::testing::Values(kDisc, kPlainBox, kWrench));

}  // namespace
}  // namespace wend::test
