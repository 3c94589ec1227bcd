#pragma once

// CarPlanner: a planner that drives a car from corner to corner. It checks queries, runs a CarEngine
// on the poses of the car, and names the moves of what it found.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/planner/lattice/car_priority.hpp"
#include "wend/planner/lattice/lattice_options.hpp"
#include "wend/planner/search_planner.hpp"
#include "wend/space/lattice/car_heuristic.hpp"
#include "wend/space/lattice/car_lattice.hpp"

namespace wend {

/// Places and goals are in lattice coordinates.
using CarEngine = SearchEngine<CornerPose, CarRegion>;

class CarPlanner final : public SearchPlanner<CarEngine> {
 public:
  /// The map has room for the lattice, and its poses can be numbered.
  CarPlanner(FreeSpace space, const CarOptions& options);
  /// The same on a lattice that exists; null on a map that has no room for it.
  CarPlanner(FreeSpace space, const CarOptions& options, std::shared_ptr<const CarLattice> lattice);

  /// Why there is no memory for its searches, if there is none.
  std::optional<Error> fault() const { return no_memory_for("the car"); }

 private:
  std::optional<Status> do_check(const Query& query) override;
  void begin_search(const Limits& limits, SearchObserver* observer) override;
  void assess(Plan& out) override;
  std::string do_reason(const Query& query, Status status) const override;
  double do_heuristic(const Pose& pose) const override;
  std::uint64_t do_state_count() const override;
  std::optional<GridMoves> do_grid_moves() const override { return std::nullopt; }
  int do_corner_unit() const override { return static_cast<int>(options_.driving.unit); }
  std::unique_ptr<Planner> do_clone() const override;
  std::optional<Error> do_update(std::span<const Cell> changed) override;

  void make_engine();

  std::optional<Status> take_goal(const Goal& goal);

  CarOptions options_;
  // None on a map that has no room for it; then there is no engine either.
  std::shared_ptr<const CarLattice> lattice_;  // clones share it
  // Of the query that was checked last.
  Pose asked_start_;
  CornerPose start_;
  std::vector<CarRegion> goals_;
  std::vector<Goal> asked_goals_;  // one for each of goals_
  std::vector<CornerPose> drive_;
};

/// The lattice resolution, in cells, for a turning radius in metres: rounded up, so that no turn is
/// tighter, and at least 1.
WEND_API std::int64_t unit_for(double turning_radius, const Frame& frame);

/// Why a car cannot drive on a map at all; empty if it can.
std::string why_no_lattice(const GridMap& map, const CarDriving& driving);

// car_reason.cpp: where and why a query fails, in words.

/// The pose of the lattice that a query's pose stands for: the nearest one, of those on the map.
/// Nothing for a pose outside the map; its heading is finite.
std::optional<CornerPose> place_on(const CarLattice& lattice, const Pose& pose);

/// Why a query ends so; empty where there is no more to say than what the status does.
std::string car_reason(const CarLattice& lattice, const Query& query, Status status);

}  // namespace wend
