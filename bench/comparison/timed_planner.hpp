#pragma once

// TimedPlanner: a planner and its times: to make it for a map, to answer the first query on the map, and
// to answer later queries.
//
//   wend::TimedPlanner planner(space, spec, wend::thread_cpu_seconds);
//   if (planner.error()) return report(planner.error()->message);
//   wend::QueryTimes times;
//   const wend::Status status = planner.answer(query, plan, times);
//
// Planners first touch their memory in their first query, and some cache results, so a first query takes
// longer. It is measured in one run of a planner made for it alone. A later query repeats a query on a
// planner that has answered it and all queries before it: the fastest of the runs of least_seconds()
// counts.

#include <limits>
#include <memory>
#include <optional>

#include "wend/base/limits.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planners.hpp"

namespace wend {

/// In seconds; NaN if it was not measured.
struct QueryTimes {
  double preparation =
      std::numeric_limits<double>::quiet_NaN();  // making the planner, with its index
  double first = std::numeric_limits<double>::quiet_NaN();
  double later = std::numeric_limits<double>::quiet_NaN();
};

class TimedPlanner {
 public:
  /// Makes the planner; an index it needs is built once, by one thread.
  TimedPlanner(FreeSpace space, PlannerSpec spec, Clock clock, const RepetitionRule& rule = {});

  /// Why the planner could not be made.
  const std::optional<Error>& error() const { return error_; }

  /// The planner that answers later queries; null if it could not be made.
  Planner* planner() const { return planner_.get(); }

  /// Does the planner keep the answer of a query that comes again? Then it does not search for later ones.
  bool resumes() const { return resumes_; }

  /// Answers a query several times. The planner must have been made. Where it resumes, the plan has the metrics of the
  /// first query.
  Status answer(const Query& query, Plan& plan, QueryTimes& times);

  /// A planner that has answered nothing yet.
  PlannerResult another() const;

 private:
  PlannerResult make();
  PlannerResult make_on_index(const PlannerInfo& info);
  void answer_first(const Query& query, Plan& plan, QueryTimes& times);

  FreeSpace space_;
  PlannerSpec spec_;
  Clock clock_;
  RepetitionRule rule_;
  double preparation_ = 0;  // of the planner made last
  double index_seconds_ = 0;
  std::optional<IndexBytes> index_;
  std::unique_ptr<Planner> planner_;
  std::optional<Error> error_;
  bool resumes_ = false;
  bool is_new_ = true;  // no query has been answered
};

}  // namespace wend
