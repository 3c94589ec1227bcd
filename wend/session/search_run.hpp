#pragma once

// SearchRun: the search for one request, from its start to its answer, under the caller's control. Session::plan() is
// begin() and finish(); who wants to see the search goes on by itself:
//
//   auto run = session.begin(request);
//   if (!run) return report(run.error().message);
//   while (!run->step()) show(run->open_list(10), run->plan().metrics);
//   const auto answer = run->finish();
//
// and the paths of an anytime planner come one by one:
//
//   while (const auto better = run->next_solution()) drive_along(better->poses());
//
// A run keeps the map and the robot of the view that it began with, whatever happens to the session, and its limits,
// cancel flag, observer and on_solution are those of the request. One thread at a time may use it. A run that is
// dropped gives its planner back.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/status.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner.hpp"
#include "wend/session/plan_request.hpp"

namespace wend {

struct RunParts;
class WarmPlanner;

class WEND_API SearchRun {
 public:
  /// Leaves the other one without a search: it can only be assigned to or destroyed.
  SearchRun(SearchRun&&) noexcept;
  /// The same.
  SearchRun& operator=(SearchRun&&) noexcept;
  SearchRun(const SearchRun&) = delete;
  SearchRun& operator=(const SearchRun&) = delete;
  ~SearchRun();

  /// Expands one state; the outcome, once there is one. Planners that cannot step (Capabilities::can_step), and requests
  /// PlanRequest::from_field, do all in the first step. If no path reaches a goal, and the request lets it end
  /// elsewhere, the search goes on to there; where an observer watches, it is known before, so that it sees one search.
  std::optional<Status> step();

  /// Goes back to before the first expansion, with the start on the open list. The outcome if the search is over there.
  std::optional<Status> restart();

  /// To the end; no slower than Planner::plan(), which it is unless the search was stepped.
  Status run();

  /// Ends a search that is not over: Status::cancelled.
  void cancel();

  /// Goes on until an anytime planner finds its next path (Planner::anytime()): the answer that finish() would give for
  /// it. Nothing after the last path: then finish() has it again, or says why there is none. Others have one path.
  std::optional<PlanAnswer> next_solution();

  /// Does a search that is over again for an observer, as far as it went, so that the time of who watches is not that of
  /// the search. Planners that resume do not search again.
  void repeat(SearchObserver& observer);

  /// Runs to the end, if that is not done, and makes the answer: eases the query, refines and times the path as the
  /// request says; or says why there is none. Takes plan(): the last thing to be called but for what only looks.
  Expected<PlanAnswer, RequestFailure> finish();

  /// Why a search that is over found no path, at length, whatever PlanRequest::explain says. O(cells log cells).
  std::string explain() const;

  /// Of a search that was stepped: the next states to expand, see Planner::open_list().
  OpenList open_list(std::size_t most) const;

  /// The path so far, between the places of the planner, and the metrics.
  const Plan& plan() const;
  /// The planner: for what else it knows, such as its heuristic and its states.
  const Planner& planner() const;
  /// What is searched for, in grid coordinates: with ends that were moved, led out or replaced.
  const Query& query() const;
  /// The way out before the path (PlanAnswer::lead_out); an empty path if there is none.
  const Path& lead() const;
  /// Sentences about what was done to the ends, until now.
  const std::vector<std::string>& notes() const;

 private:
  friend class Session;
  struct State;

  explicit SearchRun(std::unique_ptr<State> state);
  /// Takes the parts unless it fails.
  static Expected<SearchRun, RequestFailure> begin(RunParts& parts);
  std::string explain(const PlanFailure& failure);
  WarmPlanner take_planner();

  std::unique_ptr<State> state_;
};

}  // namespace wend
