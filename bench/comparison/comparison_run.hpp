#pragma once

// ComparisonRun: runs planners on the same queries, one after the other, times and measures them.
//
//   auto run = wend::ComparisonRun::make(space, *wend::parse_planner_specs("astar,bfs"), clock);
//   if (!run) return report(run.error().message);
//   for (const wend::CellPair& cells : wend::random_pairs(space, 100, 7)) run->answer(cells);
//   const std::string table = wend::comparison_table(run->comparison());
//
// One thread. The clock is passed in; times are as good as it is. See timed_planner.hpp for what is
// timed.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/comparison/comparison.hpp"
#include "bench/comparison/random_queries.hpp"
#include "bench/comparison/timed_planner.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/limits.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/leeway.hpp"

namespace wend {

class ComparisonRun {
 public:
  /// Fails if a planner rejects its options, or if the planners have different motions. A planner that
  /// cannot be made for another reason answers every query with that reason.
  static Expected<ComparisonRun, Error> make(const FreeSpace& space, std::vector<PlannerSpec> specs,
                                             const Clock& clock, const RepetitionRule& rule = {});

  /// What queries may do from now on where the robot cannot be; valid.
  void allow(const Leeway& leeway) { leeway_ = leeway; }

  /// Adds every planner's answer to one query to the comparison. Limits apply to each run of each
  /// planner.
  void answer(const CellPair& cells, const Limits& limits = {});

  /// The same for a query with one or more goals, in the grid coordinates of any motion, with its limits.
  void answer(Query query);

  /// `reason` is set for cars; for other planners only if they could not be made.
  Comparison& comparison() { return comparison_; }
  const Comparison& comparison() const { return comparison_; }

  const std::vector<PlannerSpec>& planners() const { return specs_; }

  /// How a planner on cells moves; the default for others.
  GridMoves grid_moves(std::size_t planner) const;

  /// Records a planner's search of an answered query, as far as it went.
  SearchRecorder record(std::size_t planner, std::size_t query) const;

  /// The path that the planner finds for it; empty if it finds none.
  Path path(std::size_t planner, std::size_t query) const;

 private:
  explicit ComparisonRun(FreeSpace space) : space_(std::move(space)) {}

  ComparisonRow answer_of(std::size_t planner, const Query& query);
  Status plan_eased(TimedPlanner& timed, const Query& query, ComparisonRow& row);
  static void describe(const Path& path, const FreeSpace& space, ComparisonRow& row);
  Plan again(std::size_t planner, std::size_t query, SearchObserver* observer) const;

  FreeSpace space_;
  std::vector<PlannerSpec> specs_;
  std::vector<TimedPlanner> planners_;  // the same
  Leeway leeway_;
  Comparison comparison_;
  Plan plan_;
};

}  // namespace wend
