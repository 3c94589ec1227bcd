// The planners that keep what they found, on maps that change under a robot that moves.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "conformance/random_edit.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/planner/costs/cost_oracle_test.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

using test::kNoUnits;

constexpr std::array<const char*, 2> kPlanners{"replanner", "d_star_lite"};

GridMoves random_moves(Random& random) {
  const Connectivity connectivity = random.chance(0.2) ? Connectivity::four : Connectivity::eight;
  const int corners = random.chance(0.6) ? 0 : random.between(1, 2);
  return {connectivity, static_cast<CornerRule>(corners)};
}

FreeSpace random_space_to_edit(Random& random) {
  if (random.chance(0.6)) return test::random_cost_space(random);
  const double blocked = 0.4 * random.uniform();
  const int width = random.between(1, 40);
  const int height = random.between(1, 40);
  Grid<CellState> states(width, height, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(blocked)) states[cell] = CellState::occupied;
  }
  return *make_free_space(*make_grid_map(states));
}

/// A robot that plans, moves, and whose map is edited; every answer is compared with Dijkstra's.
class Drive {
 public:
  Drive(const char* planner, std::uint64_t seed)
      : random_(seed), space_(random_space_to_edit(random_)), moves_(random_moves(random_)) {
    planner_ = *make_planner(planner, space_, option_values(BfsOptions{moves_}));
    start_ = test::random_cell_of(space_, random_);
    goal_ = test::random_cell_of(space_, random_);
    tolerance_ = random_.chance(0.8) ? 0 : 3 * random_.uniform();
  }

  void change_something() {
    if (random_.chance(0.6)) edit();
    if (random_.chance(0.1)) goal_ = test::random_cell_of(space_, random_);
    if (random_.chance(0.1)) {
      start_ = test::random_cell_of(space_, random_);
    } else if (!path_.empty()) {
      start_ = path_[random_.below(path_.size())];
    }
  }

  /// The number of paths found.
  int ask() {
    const Query query{pose_at(start_), {Goal(centre_of(goal_), tolerance_)}};
    Plan plan;
    const Status status = planner_->plan(query, plan);
    const std::uint64_t least = least_units();
    path_.assign(plan.path.cells().begin(), plan.path.cells().end());
    if (!space_.passable(start_)) {
      EXPECT_EQ(status, Status::start_blocked);
      return 0;
    }
    if (least == kNoUnits) {
      EXPECT_TRUE(status == Status::unreachable || status == Status::goal_blocked)
          << to_string(status);
      return 0;
    }
    EXPECT_EQ(status, Status::found) << to_string(status);
    if (status != Status::found) return 0;
    EXPECT_TRUE(check_grid_path(space_, moves_, path_));
    EXPECT_EQ(path_.front(), start_);
    EXPECT_LE(path_.back() == goal_ ? 0 : distance(centre_of(path_.back()), centre_of(goal_)),
              tolerance_ + Goal::kRounding);
    EXPECT_EQ(test::units_of(space_, path_), least);
    return 1;
  }

 private:
  void edit() {
    const bool terrain = !space_.uniform_terrain() || random_.chance(0.05);
    const MapEdit edit = test::random_edit(random_, space_.map(), terrain);
    if (random_.chance(0.5)) planner_->release();
    const auto change = space_.edit(edit);
    ASSERT_TRUE(change);
    ASSERT_TRUE(planner_->update(space_, *change));
  }

  std::uint64_t least_units() const {
    if (!space_.passable(start_)) return kNoUnits;
    const auto units = test::units_from(space_, moves_, start_);
    std::uint64_t least = kNoUnits;
    for (const Cell cell : every_cell(space_.map())) {
      const bool is_goal =
          cell == goal_ || Goal(centre_of(goal_), tolerance_).reaches(centre_of(cell));
      if (is_goal)
        least = std::min(least, units[static_cast<std::size_t>(cell.y * space_.width() + cell.x)]);
    }
    return least;
  }

  Random random_;
  FreeSpace space_;
  GridMoves moves_;
  std::unique_ptr<Planner> planner_;
  Cell start_;
  Cell goal_;
  double tolerance_;
  std::vector<Cell> path_;
};

TEST(Replanning, FindsACheapestPathAfterEveryChange) {
  constexpr int kRounds = 20;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(test::share_of(3000U)) && !HasFailure();
       ++seed) {
    for (const char* const planner : kPlanners) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + planner);
      Drive drive(planner, seed);
      for (int round = 0; round < kRounds && !HasFailure(); ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        if (round > 0) drive.change_something();
        found += drive.ask();
      }
    }
  }
  EXPECT_GT(found, test::share_of(test::share_of(50000)));
}

}  // namespace
}  // namespace wend
