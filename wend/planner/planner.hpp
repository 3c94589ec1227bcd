#pragma once

// Planner: the one door to every planner.
//
// A planner is made for one FreeSpace, owns its scratch memory and reuses it from query to query:
// a short query on a large map does not pay for the map's size. One planner per thread; the
// FreeSpace may be shared.
//
//   auto planner = wend::make_planner("astar", space, {{"weight", "1.5"}});
//   if (!planner) return report(planner.error().message());
//   const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
//   if (!plan) return report(plan.error().reason);

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/base/status.hpp"
#include "wend/map/free_space.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

class Planner {
 public:
  virtual ~Planner() = default;
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;

  const FreeSpace& free_space() const { return free_space_; }

  /// Answers a query.
  Expected<Plan, PlanFailure> plan(const Query& query);

  /// The same into buffers that the caller keeps: allocates nothing once planner and plan are warm.
  /// On failure the path is empty, the cost infinite and the metrics tell the work until then.
  Status plan(const Query& query, Plan& out);

  /// The same one expansion at a time, for planners that can be stepped (PlannerInfo::can_step):
  /// begin a query, then step until an outcome comes. Limits hold, and the observer is told.
  ///   auto outcome = planner.begin(query, plan);
  ///   while (!outcome) outcome = planner.step(plan);
  std::optional<Status> begin(const Query& query, Plan& out);
  std::optional<Status> step(Plan& out) { return do_step(out); }

  /// Of a search that is stepped: the states that it would expand next, the next one first, at most
  /// `most` of them, and how many are open. The search goes on as if nobody had asked. O(entries of
  /// the frontier).
  OpenList open_list(std::size_t most) const { return do_open_list(most); }

  /// Why a query of this planner ends with a status: in words, with where and what is there.
  std::string reason(const Query& query, Status status) const;

  /// The estimate of the cost from a pose on the map, in grid coordinates, to the goals of the
  /// search begun last, as that search used it; 0 where the planner estimates nothing.
  double heuristic(const Pose& pose) const { return do_heuristic(pose); }
  double heuristic(Cell cell) const { return do_heuristic(pose_at(cell)); }

  /// How many states there are in which the robot may be.
  std::uint64_t state_count() const { return do_state_count(); }

  /// Of a car: how many cells the corners that it stands on lie apart. 0: it stands in cells.
  int corner_unit() const { return do_corner_unit(); }

  /// Plans on another FreeSpace from now on. `changed` names the cells in which it may differ, for
  /// planners that keep what the others do not touch; the size may only change if it is empty.
  void update(FreeSpace free_space, std::span<const Cell> changed = {});

 protected:
  explicit Planner(FreeSpace free_space) : free_space_(std::move(free_space)) {}

 private:
  /// Space-specific validation: a reason why the query cannot be answered, before any search.
  virtual std::optional<Status> do_check(const Query& query) = 0;
  /// The algorithm; the query has been checked, `out` has been cleared.
  virtual Status do_plan(const Query& query, Plan& out) = 0;
  virtual std::optional<Status> do_begin(const Query& /*query*/, Plan& /*out*/) {
    return Status::unsupported_query;
  }
  virtual std::optional<Status> do_step(Plan& /*out*/) { return Status::unsupported_query; }
  virtual OpenList do_open_list(std::size_t /*most*/) const { return {}; }
  /// Where and why; empty where there is no more to say than what the status does.
  virtual std::string do_reason(const Query& /*query*/, Status /*status*/) const { return {}; }
  virtual double do_heuristic(const Pose& /*pose*/) const { return 0; }
  virtual std::uint64_t do_state_count() const { return free_space_.passable().count(); }
  virtual int do_corner_unit() const { return 0; }
  virtual void do_update(std::span<const Cell> changed) = 0;

  std::optional<Status> check(const Query& query, Plan& out);

  FreeSpace free_space_;
};

}  // namespace wend
