#pragma once

// Planner: the interface of every planner.
//
// A planner is made for one FreeSpace. It owns its scratch memory and reuses it for later queries,
// so the time of a short query does not depend on the map's size. Use one planner per thread;
// threads may share the FreeSpace.
//
//   auto planner = wend::make_planner("astar", space, {{"weight", "1.5"}});
//   if (!planner) return report(planner.error().message);
//   const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
//   if (!plan) return report(wend::words_of(plan.error(), space));

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/status.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/planner/failure.hpp"
#include "wend/planner/leaving_motion.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/space_change.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

class WEND_API Planner {
 public:
  virtual ~Planner() = default;
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;

  /// The space that the planner plans in. Not between release() and update().
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access)
  const FreeSpace& free_space() const { return *free_space_; }

  /// Answers a query.
  Expected<Plan, PlanFailure> plan(const Query& query);

  /// The same into the caller's buffers: allocates nothing once planner and plan are warm. On
  /// failure the path is empty, the cost is infinite, and the metrics are those of the search until
  /// then.
  Status plan(const Query& query, Plan& out);

  /// The same one expansion at a time, for planners that can be stepped (Capabilities::can_step):
  /// begin a query, then step until there is an outcome. Limits and the observer work as in plan(). Of an
  /// anytime planner, the plan has the best path so far once there is one.
  ///
  ///   auto outcome = planner.begin(query, plan);
  ///   while (!outcome) outcome = planner.step(plan);
  std::optional<Status> begin(const Query& query, Plan& out);
  /// Expands one state; the outcome, once there is one.
  std::optional<Status> step(Plan& out);

  /// For a stepped search: the next states to expand, at most `most`, in order, and the number of
  /// open states. Does not change the search. O(entries of the frontier).
  OpenList open_list(std::size_t most) const { return do_open_list(most); }

  /// Does it find paths until the best or a limit, each with its bound (Query::on_solution)? Some planners do
  /// with some options: `car` and `lattice` with an initial_weight above 1.
  bool anytime() const { return do_anytime(); }

  /// Why a query ends with this status: where, and what is there. About the query that was planned last where only the
  /// search knows.
  Failure failure(const Query& query, Status status) const;

  /// The heuristic of the last search, from a pose on the map, in grid coordinates, to its goals; 0
  /// for a planner without a heuristic.
  double heuristic(const Pose& pose) const { return do_heuristic(pose); }
  /// The same from the centre of a cell, with heading 0.
  double heuristic(Cell cell) const { return do_heuristic(pose_at(cell)); }

  /// The number of valid states.
  std::uint64_t state_count() const { return do_state_count(); }

  /// How it steps from cell to cell; nothing if its states have headings.
  std::optional<GridMoves> grid_moves() const { return do_grid_moves(); }

  /// For a planner with headings: the point of a goal, or of a start, if the planner has a free place there or
  /// within the tolerance; else the nearest point, in grid coordinates, at which it has one with the goal's
  /// heading. Nothing if there is none, or if the goal is not finite; nothing for a planner on cells, for which
  /// nearest_ends() finds places. O(places examined).
  std::optional<Point> nearest_free(const Goal& goal) const { return do_nearest_free(goal); }

  /// What is left of a path that a planner with the same options found before to the query's goals, for a robot at
  /// the query's start: legal on the present free space, with what it costs there. Only `path`, `cost`, `moves` and
  /// `start_snapping_error` are set. It joins the start to the path ahead by moves of the planner; on a lattice it
  /// begins on the path, where that is nearest to the start. `passed` is the index of a cell, waypoint or pose behind
  /// the robot, 0 at first, and is brought up to date. Nothing if the rest is not free any more, if the start is too
  /// far from it, or if the planner has no such function. O(length of the path).
  std::optional<Plan> rest_of(const Path& path, const Query& query, std::size_t& passed) const {
    return do_rest_of(path, query, passed);
  }

  /// The pose at which a path from this one begins, free or not: the middle of its cell, the nearest place of a
  /// lattice, the pose itself. Nothing if it is not on the map. Grid coordinates.
  std::optional<Pose> place_of(const Pose& pose) const { return do_place_of(pose); }

  /// For a planner with headings: what its robot can drive from such a place, whether it fits there or not; motions
  /// that may end anywhere are about `most` cells long. Empty for a planner on cells.
  std::vector<LeavingMotion> motions_from(const Pose& place, double most) const {
    return do_motions_from(place, most);
  }

  /// Where its states lie: in the middles of cells, or on the vertices of its lattice.
  PlaceGrid place_grid() const { return do_place_grid(); }

  /// Another planner with the same options on the same FreeSpace, for another thread. It shares what
  /// this one has prepared (jump points, an index, a lattice), and has its own memory for searches: if
  /// there is none left, its queries end with Status::memory_limit. Do not call it while another thread
  /// uses this planner.
  std::unique_ptr<Planner> clone() const { return do_clone(); }

  /// Replaces the FreeSpace. `change` says what may differ from the last one, for planners that keep what
  /// they have prepared of the rest; answers do not depend on it. Fails with unsupported_map,
  /// memory_limit or index_mismatch, as making the planner on this space would; then every query fails until
  /// an update succeeds.
  Expected<void, Error> update(FreeSpace free_space,
                               const SpaceChange& change = SpaceChange::of_everything());

  /// Lets go of the FreeSpace, so that FreeSpace::edit() need not copy it. Nothing else than update() may
  /// be called next.
  void release();

 protected:
  /// For derived classes.
  explicit Planner(FreeSpace free_space) : free_space_(std::move(free_space)) {}

  /// Makes it the plan of a query without a path.
  static void clear(Plan& out);
  /// Tells a path of the present query to Query::on_solution, unless the last one had the same cost and bound.
  void tell_solution(const Plan& plan);

 private:
  /// Space-specific validation: a reason why the query cannot be answered, before any search.
  virtual std::optional<Status> do_check(const Query& query) = 0;
  /// The algorithm; the query has been checked, `out` has been cleared.
  virtual Status do_plan(const Query& query, Plan& out) = 0;
  virtual std::optional<Status> do_begin(const Query& /*query*/, Plan& /*out*/) {
    return Status::unsupported_query;
  }
  virtual std::optional<Status> do_step(Plan& /*out*/) { return Status::unsupported_query; }
  virtual bool do_anytime() const { return false; }
  virtual OpenList do_open_list(std::size_t /*most*/) const { return {}; }
  /// Failure::causes of a valid query; empty if the status says it all. By itself it looks at cells. A planner from
  /// outside may return an OwnText.
  virtual std::vector<FailureCause> do_failure(const Query& query, Status status) const;
  virtual double do_heuristic(const Pose& /*pose*/) const { return 0; }
  virtual std::uint64_t do_state_count() const { return free_space().passable().count(); }
  virtual std::optional<GridMoves> do_grid_moves() const { return GridMoves{}; }
  virtual std::optional<Point> do_nearest_free(const Goal& /*goal*/) const { return std::nullopt; }
  virtual std::optional<Plan> do_rest_of(const Path& /*path*/, const Query& /*query*/,
                                         std::size_t& /*passed*/) const {
    return std::nullopt;
  }
  virtual std::optional<Pose> do_place_of(const Pose& pose) const;
  virtual std::vector<LeavingMotion> do_motions_from(const Pose& /*place*/, double /*most*/) const {
    return {};
  }
  virtual PlaceGrid do_place_grid() const { return cells_of(free_space()); }
  virtual std::unique_ptr<Planner> do_clone() const = 0;
  /// Why the planner cannot plan on the new free_space(), if it cannot.
  virtual std::optional<Error> do_update(const SpaceChange& change) = 0;
  /// Deletes what holds the FreeSpace or points into it.
  virtual void do_release() {}

  std::optional<Status> check(const Query& query, Plan& out);
  void watch_solutions(const Query& query);

  OnSolution on_solution_;  // of the present query
  double told_cost_ = 0;
  double told_bound_ = 0;
  std::optional<FreeSpace> free_space_;  // nothing between release() and update()
};

}  // namespace wend
