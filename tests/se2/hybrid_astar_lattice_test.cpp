// hybrid_astar against lattice, and lattice against an exhaustive search over its primitives, on small random maps:
// wherever there is a drive on the lattice, hybrid_astar finds one, which costs at most a tenth more. In one drive of
// a thousand it may cost up to a half more, and is printed: hybrid_astar keeps one pose of a box, and in tight places
// that may be the one from which the cheaper drive does not fit. It searches its boxes to the end there; more
// expansions after the first drive change nothing.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "conformance/random_map.hpp"
#include "tests/testing/primitive_distances.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kSmallMapResolution = 0.1;  // metres
constexpr double kTurningRadius = 0.3;
constexpr double kDearer = 1.1;  // than on the lattice
constexpr double kMostDearer = 1.5;
constexpr int kDrivesPerDearer = 1000;

/// A small map in metres, with few obstacles or many.
GridMap scattered_map(Random& random) {
  const int width = random.between(8, 24);
  const int height = random.between(8, 24);
  const auto share = one_of<double>(random, std::array{0.0, 0.03, 0.06, 0.1, 0.2});
  Grid<CellState> states(width, height, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(share)) states[cell] = CellState::occupied;
  }
  Frame frame;
  frame.resolution = kSmallMapResolution;
  frame.metric = true;
  return *make_grid_map(states, frame);
}

Footprint random_footprint(Random& random) {
  if (random.chance(0.5)) {
    return Footprint::disc(one_of<double>(random, std::array{0.1, 0.15, 0.22}));
  }
  return *parse_footprint("0.3,0.15; -0.1,0.15; -0.1,-0.15; 0.3,-0.15");
}

/// Between poses of the lattice; the robot fits at most of them.
Query random_lattice_query(Random& random, const FreeSpace& space, const MotionPrimitives& set) {
  const auto pose = [&] {
    constexpr int kTries = 20;
    Pose drawn;
    for (int i = 0; i < kTries && (i == 0 || !space.fits(drawn)); ++i) {
      const Cell cell = random_cell(random, space.width(), space.height());
      drawn = pose_at(cell, set.headings()[random.below(set.headings().size())]);
    }
    return drawn;
  };
  const Pose start = pose();
  return {start, {Goal(pose())}};
}

/// What both planners say, query by query, and where they disagree.
class Comparison {
 public:
  void compare_on(std::uint64_t seed) {
    Random random(seed);
    const GridMap map = scattered_map(random);
    const FreeSpace space = *make_free_space(map, {.footprint = random_footprint(random)});
    const auto lattice = *make_planner("lattice", space, options());
    OptionValues same = options();
    same.emplace_back("turn_factor", "1");
    same.emplace_back("time_budget", "1000");  // on slow machines, too
    const auto hybrid = *make_planner("hybrid_astar", space, same);
    const MotionPrimitives set =
        *MotionPrimitives::turning_circle(kTurningRadius / kSmallMapResolution);
    for (int i = 0; i < 4; ++i) {
      where_ = fmt::format("seed {}, query {}", seed, i);
      const Query query = random_lattice_query(random, space, set);
      const auto on_lattice = lattice->plan(query);
      if (i == 0) hold_to_exhaustive(on_lattice, query, space, set);
      if (on_lattice) hold(hybrid->plan(query), on_lattice->cost, space);
    }
  }

  int found() const { return found_; }
  int exhaustive() const { return exhaustive_; }
  int dearer() const { return dearer_; }

 private:
  static OptionValues options() {
    return {{"turning_radius", fmt::format("{}", kTurningRadius)}, {"reverse_factor", "2"}};
  }

  void hold_to_exhaustive(const Expected<Plan, PlanFailure>& plan, const Query& query,
                          const FreeSpace& space, const MotionPrimitives& set) {
    const double least = least_cost(query, space, set);
    if (!plan) {
      EXPECT_EQ(least, kNoMotion) << where_;
      return;
    }
    ++exhaustive_;
    EXPECT_NEAR(plan->cost, least, 1e-9 * (1 + least)) << where_;
  }

  static double least_cost(const Query& query, const FreeSpace& space,
                           const MotionPrimitives& set) {
    if (!space.fits(query.start)) return kNoMotion;
    const auto state = [&](Point point, double heading) {
      return GridPose{cell_at(point), set.nearest_heading(heading)};
    };
    const Goal& goal = query.goals.front();
    const auto costs =
        PrimitiveDistances(space, set, 2, 1).from(state(query.start.point(), query.start.heading));
    const auto found = costs.find(state(goal.point, *goal.heading));
    return found == costs.end() ? kNoMotion : found->second;
  }

  void hold(const Expected<Plan, PlanFailure>& plan, double cost, const FreeSpace& space) {
    ++found_;
    if (!plan) {
      ADD_FAILURE() << where_ << ": lattice finds a drive that costs " << cost
                    << ", hybrid_astar: " << to_string(plan.error().status) << ", "
                    << plan.error().message;
      return;
    }
    EXPECT_LE(plan->cost, kMostDearer * cost + 1e-9) << where_ << ": lattice finds a cheaper drive";
    if (plan->cost > kDearer * cost + 1e-9) {
      ++dearer_;
      fmt::print("{}: {:.3f} times the cost on the lattice\n", where_, plan->cost / cost);
    }
    EXPECT_FALSE(first_collision(plan->path, space)) << where_;
  }

  std::string where_;
  int found_ = 0;
  int exhaustive_ = 0;
  int dearer_ = 0;
};

void compare_on_small_maps(std::uint64_t maps) {
  Comparison comparison;
  for (std::uint64_t seed = 0; seed < maps; ++seed) comparison.compare_on(seed);
  fmt::print("{} maps, {} drives on the lattice, {} of them compared with an exhaustive search\n",
             maps, comparison.found(), comparison.exhaustive());
  EXPECT_GT(comparison.found(), static_cast<int>(maps));
  EXPECT_LE(comparison.dearer(), comparison.found() / kDrivesPerDearer);
}

TEST(HybridAStarAndLattice, AgreeOnSmallMaps) { compare_on_small_maps(share_of(100U)); }

TEST(HybridAStarAndLattice, AgreeOnManySmallMapsInALongRun) { compare_on_small_maps(10000); }

}  // namespace
}  // namespace wend::test
