#pragma once

// HybridPlanner: the planner hybrid_astar: takes queries apart, runs a HybridSearch, and writes its path.

#include <memory>
#include <optional>
#include <vector>

#include "wend/planner/planner.hpp"
#include "wend/planner/se2/hybrid_astar_options.hpp"
#include "wend/planner/se2/hybrid_goal.hpp"
#include "wend/planner/se2/hybrid_ground.hpp"
#include "wend/planner/se2/hybrid_portfolio.hpp"

namespace wend {

class HybridPlanner final : public Planner {
 public:
  /// Cars have a turning radius above 0.
  HybridPlanner(const FreeSpace& space, const HybridAStarOptions& options);

 private:
  HybridPlanner(FreeSpace space, const HybridAStarOptions& options,
                std::shared_ptr<const HybridGround> ground);

  std::optional<Status> do_check(const Query& query) override;
  Status do_plan(const Query& query, Plan& out) override;
  std::vector<FailureCause> do_failure(const Query& query, Status status) const override;
  double do_heuristic(const Pose& pose) const override;
  std::uint64_t do_state_count() const override;
  std::optional<GridMoves> do_grid_moves() const override { return std::nullopt; }
  std::optional<Point> do_nearest_free(const Goal& goal) const override;
  std::optional<Plan> do_rest_of(const Path& path, const Query& query,
                                 std::size_t& passed) const override;
  std::optional<Pose> do_place_of(const Pose& pose) const override;
  std::vector<LeavingMotion> do_motions_from(const Pose& place, double most) const override;
  std::unique_ptr<Planner> do_clone() const override;
  std::optional<Error> do_update(const SpaceChange& change) override;
  void do_release() override;

  NoDriveFound why_no_drive(const Query& query) const;
  std::optional<FailureCause> why_no_place(std::size_t index, const Goal& goal) const;
  std::optional<Status> take_goal(const Query& query, std::size_t index);
  std::optional<HybridGoal> place_for(const Goal& goal, const std::optional<Cell>& from = {}) const;
  std::optional<double> heading_at(Point point, const Goal& goal) const;
  void write(const Query& query, const HybridSearch& finder, Plan& out);
  void name_moves(Plan& plan) const;

  HybridAStarOptions options_;
  Steering steering_;
  std::shared_ptr<const HybridGround> ground_;
  std::shared_ptr<GoalRing> ring_;  // does not depend on the map, so that it outlives edits
  std::unique_ptr<HybridPortfolio> search_;
  std::unique_ptr<DriveShortener> shortener_;
  DrivenMotions drive_;
  std::vector<HybridGoal> goals_;
};

}  // namespace wend
