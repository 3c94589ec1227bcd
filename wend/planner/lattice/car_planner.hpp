#pragma once

// CarPlanner: a planner that drives a car from corner to corner. It checks queries, runs the
// CarEngine that it was made with, and names the moves of what it found.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/planner/lattice/car_engine.hpp"
#include "wend/planner/planner.hpp"
#include "wend/space/lattice/car_driving.hpp"
#include "wend/space/lattice/car_heuristic.hpp"

namespace wend {

struct CarOptions {
  CarDriving driving;
  CarHeuristic heuristic = CarHeuristic::headings;
  double weight = 1;

  /// Plan::bound of every answer.
  double bound() const { return weight > 1 ? weight : 1; }
};

class CarPlanner final : public Planner {
 public:
  /// The map has room for the lattice, and its poses can be numbered.
  CarPlanner(FreeSpace space, const CarOptions& options);

  bool allocated() const { return engine_ != nullptr && engine_->allocated(); }

 private:
  std::optional<Status> do_check(const Query& query) override;
  Status do_plan(const Query& query, Plan& out) override;
  std::optional<Status> do_begin(const Query& query, Plan& out) override;
  std::optional<Status> do_step(Plan& out) override;
  OpenList do_open_list(std::size_t most) const override;
  std::string do_reason(const Query& query, Status status) const override;
  double do_heuristic(const Pose& pose) const override;
  std::uint64_t do_state_count() const override;
  int do_corner_unit() const override { return static_cast<int>(options_.driving.unit); }
  void do_update(std::span<const Cell> changed) override;

  /// Makes lattice and engine, if the map allows it.
  void make();
  std::optional<Status> take_goal(const Goal& goal);
  Status finish(SearchOutcome outcome, Plan& out);

  CarOptions options_;
  std::unique_ptr<const CarLattice> lattice_;  // none on a map that has no room for it
  std::unique_ptr<CarEngine> engine_;
  // Of the query that was checked last.
  Pose asked_start_;
  CornerPose start_;
  std::vector<CarGoal> goals_;
  std::vector<Goal> asked_goals_;  // one for each of goals_
  std::vector<CornerPose> drive_;
  Limits limits_;  // of a search that is stepped
};

/// How many cells wide the lattice of a car is that turns on circles of that radius, in metres: rounded
/// up, so that no circle is tighter, and at least 1.
std::int64_t unit_for(double turning_radius, const Frame& frame);

/// Why a car cannot drive on a map at all; empty if it can.
std::string why_no_lattice(const GridMap& map, const CarDriving& driving);

}  // namespace wend
