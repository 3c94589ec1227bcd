#pragma once

// BenchWorker: asks the queries of a scenario in one thread, times and checks the answers. Times are CPU
// time of that thread.

#include <functional>
#include <memory>
#include <string>

#include "bench/scenario/bench_answer.hpp"
#include "bench/scenario/scenario_verdict.hpp"
#include "wend/io/query/scenario.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

/// What all queries of a worker have in common.
struct WorkerRules {
  GridMoves moves;
  double limit_s = 0;  // time limit of a query; 0: none
  PathKind path_kind = PathKind::steps;
};

class BenchWorker {
 public:
  using Make = std::function<PlannerResult()>;

  /// Gets what is wrong with an answer, once per query. Called in this worker's thread.
  using Complain = std::function<void(const ScenarioQuery& query, const std::string& wrong)>;

  /// `make` is called for every first query. `space` must outlive the worker.
  BenchWorker(const FreeSpace& space, Make make, WorkerRules rules, Complain complain);

  /// Sets the planner for later queries. It answers the query untimed: fresh memory costs time.
  void keep(std::unique_ptr<Planner> planner, const ScenarioQuery& query);

  /// Times one run of a new planner. After Ctrl-C, it and those below return false and change nothing.
  bool time_first(const ScenarioQuery& query, BenchAnswer& answer);

  /// Repeats a query with the kept planner: the fastest of the runs that fill 5 ms counts.
  bool time_later(const ScenarioQuery& query, BenchAnswer& answer);

  /// Repeats a query with a new planner.
  bool time_fresh(const ScenarioQuery& query, BenchAnswer& answer);

 private:
  Query asked(const ScenarioQuery& query) const;
  static void watch(Planner& planner, Query query, BenchAnswer& answer);
  void take(const ScenarioQuery& query, BenchAnswer& answer, Status status, const Plan& plan);
  void settle(const ScenarioQuery& query, BenchAnswer& answer, Status status, const Plan& plan);
  void compare(const ScenarioQuery& query, BenchAnswer& answer, Status status, const Plan& plan);
  void judge(const ScenarioQuery& query, BenchAnswer& answer, const std::string& wrong);

  const FreeSpace& space_;
  Make make_;
  WorkerRules rules_;
  Complain complain_;
  std::unique_ptr<Planner> planner_;
  Plan plan_;
};

}  // namespace wend::cli
