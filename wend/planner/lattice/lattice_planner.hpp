#pragma once

// LatticePlanner: a planner that moves a robot by motion primitives: those of the FreeSpace's robot, or a
// built-in set. It checks queries, runs a LatticeEngine, and makes a path of segments of what it found.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/planner/lattice/lattice_priority.hpp"
#include "wend/planner/search_planner.hpp"
#include "wend/space/lattice/motion_lattice.hpp"

namespace wend {

using LatticeEngine = SearchEngine<LatticePose, LatticeGoal>;

struct LatticeOptions {
  LatticeCosts costs;
  LatticeHeuristic heuristic = LatticeHeuristic::obstacles;
  double weight = 1;

  /// Plan::bound of every answer.
  double bound() const { return weight > 1 ? weight : 1; }
};

class LatticePlanner final : public SearchPlanner<LatticeEngine> {
 public:
  /// MotionLattice::why_none() is empty.
  LatticePlanner(FreeSpace space, MotionPrimitives primitives, const LatticeOptions& options);
  /// The same on a lattice that exists; null on a map that does not suit the primitives.
  LatticePlanner(FreeSpace space, MotionPrimitives primitives, const LatticeOptions& options,
                 std::shared_ptr<const MotionLattice> lattice);

  /// Why there is no memory for its searches, if there is none.
  std::optional<Error> fault() const { return no_memory_for("the robot"); }

 private:
  std::optional<Status> do_check(const Query& query) override;
  void begin_search(const Limits& limits, SearchObserver* observer) override;
  void assess(Plan& out) override;
  std::string do_reason(const Query& query, Status status) const override;
  double do_heuristic(const Pose& pose) const override;
  std::optional<GridMoves> do_grid_moves() const override { return std::nullopt; }
  std::uint64_t do_state_count() const override;
  std::unique_ptr<Planner> do_clone() const override;
  std::optional<Error> do_update(std::span<const Cell> changed) override;

  void make_engine();

  std::optional<Status> take_goal(const Goal& goal);
  bool fits(const LatticePose& place) const;

  MotionPrimitives primitives_;
  LatticeOptions options_;
  // Null if the map's resolution does not suit the primitives; then there is no engine either.
  std::shared_ptr<const MotionLattice> lattice_;  // clones share it
  // Of the query that was checked last.
  Pose asked_start_;
  LatticePose start_;
  std::vector<LatticeGoal> goals_;
  std::vector<Goal> asked_goals_;  // one for each of goals_
  std::vector<Pose> states_;       // of the path
};

}  // namespace wend
