#pragma once

// BenchLane: a planner that answers the queries of a scenario in one thread, timed and checked.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "wend/io/scenario.hpp"
#include "wend/planner/planner.hpp"
#include "wend/report/bench_answer.hpp"

namespace wend::cli {

class BenchLane {
 public:
  /// Told what is wrong with the answer to a query, once for each that is. From this lane's thread.
  using Complain = std::function<void(const ScenarioQuery& query, const std::string& wrong)>;

  BenchLane(std::unique_ptr<Planner> planner, Complain complain);

  /// Asks a query that is not to be measured: fresh memory costs time.
  void warm_up(const ScenarioQuery& query);

  /// One more pass of a query: adds its seconds. Only the first pass of an answer sets what else
  /// there is to say, when it is settled. False, and nothing was done, if Ctrl-C came.
  bool time(const ScenarioQuery& query, BenchAnswer& answer);

  /// Settles the answers that were too quick to be checked in between: that would push out of the
  /// caches what the next query needs. They are asked again. False if Ctrl-C came: their seconds
  /// are taken back.
  bool settle();

 private:
  struct Unsettled {
    const ScenarioQuery* query;
    BenchAnswer* answer;
  };

  bool ask(const ScenarioQuery& query);
  void settle(const ScenarioQuery& query, BenchAnswer& answer);
  void compare(const ScenarioQuery& query, BenchAnswer& answer);
  void judge(const ScenarioQuery& query, BenchAnswer& answer, const std::string& wrong);

  std::unique_ptr<Planner> planner_;
  Complain complain_;
  Status status_ = Status::found;
  Plan plan_;
  double seconds_ = 0;
  std::vector<Unsettled> unsettled_;
};

}  // namespace wend::cli
