#pragma once

// LatticePlanner: a planner that moves a robot by motion primitives: those of the FreeSpace's robot, or a
// built-in set. It checks queries, runs a LatticeEngine, and makes a path of segments of what it found.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/planner/lattice/lattice_options.hpp"
#include "wend/planner/lattice/lattice_priority.hpp"
#include "wend/planner/search_planner.hpp"
#include "wend/space/lattice/motion_lattice.hpp"

namespace wend {

using LatticeEngine = SearchEngine<LatticePose, LatticeGoal>;

class LatticePlanner final : public SearchPlanner<LatticeEngine> {
 public:
  /// The primitives for a space: they depend on its robot and resolution. Called again for another space.
  using PrimitivesChooser = std::function<Expected<MotionPrimitives, Error>(const FreeSpace&)>;

  LatticePlanner(FreeSpace space, PrimitivesChooser choose_primitives,
                 const LatticeOptions& options);

  /// Why it cannot plan in its space, if it cannot.
  const std::optional<Error>& fault() const { return fault_; }

 private:
  LatticePlanner(const LatticePlanner& other, FreeSpace space);

  std::optional<Status> do_check(const Query& query) override;
  void begin_search(const Limits& limits, SearchObserver* observer) override;
  void assess(Plan& out) override;
  std::string do_reason(const Query& query, Status status) const override;
  double do_heuristic(const Pose& pose) const override;
  std::optional<GridMoves> do_grid_moves() const override { return std::nullopt; }
  std::uint64_t do_state_count() const override;
  std::unique_ptr<Planner> do_clone() const override;
  std::optional<Error> do_update(std::span<const Cell> changed) override;

  std::optional<Error> prepare();
  std::optional<Error> make_engine();

  std::optional<Status> take_goal(const Goal& goal);
  bool fits(const LatticePose& place) const;

  PrimitivesChooser choose_primitives_;
  LatticeOptions options_;
  std::optional<Error> fault_;
  // Null if the space has no primitives; engine_ is then null too.
  std::shared_ptr<const MotionLattice> lattice_;  // clones share it
  // Of the query that was checked last.
  Pose asked_start_;
  LatticePose start_;
  std::vector<LatticeGoal> goals_;
  std::vector<Goal> asked_goals_;  // one for each of goals_
  std::vector<Pose> states_;       // of the path
};

}  // namespace wend
