#pragma once

// BenchRace: contestants on one course, in turns, pass after pass.

#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "bench/scenario/bench_plot.hpp"
#include "bench/scenario/bench_rows.hpp"
#include "cli/commands/bench/bench_contestant.hpp"
#include "cli/commands/bench/bench_course.hpp"
#include "cli/commands/bench/bench_lane.hpp"
#include "cli/commands/bench/bench_settings.hpp"
#include "cli/commands/bench/bench_store.hpp"
#include "cli/output/progress_bar.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/map/free_space.hpp"

namespace wend::cli {

/// The queries that one of several ranks answers: a few in a row, then some of the others'.
struct BenchShare {
  std::size_t rank = 0;
  std::size_t ranks = 1;

  bool contains(std::size_t query) const {
    constexpr std::size_t kInARow = 16;
    return query / kInARow % ranks == rank;
  }
};

/// How far all races are.
struct BenchProgress {
  ProgressBar bar;
  std::uint64_t done = 0;   // queries, of every contestant and pass
  std::uint64_t known = 0;  // those of them that the store had
};

class BenchRace {
 public:
  /// Takes what the store knows for answered; all that it is given must outlive this.
  BenchRace(const Course& course, const std::vector<Contestant>& contestants,
            const BenchSettings& settings, BenchStore& store, BenchShare share = {});

  /// Asks every contestant every query of the share until it has all passes. Throws Cancelled if Ctrl-C
  /// came: what was answered until then is stored. Throws InputError if a contestant does not take
  /// its options or the map.
  void run(const std::vector<GivenIndex>& indexes, BenchProgress& progress);

  /// What came of it, a row a contestant: of the whole course only.
  std::vector<BenchRow> rows() const;

  /// The same with every answer, for plots.
  std::vector<BenchedMap> benched() const;

 private:
  struct Runner {
    const Contestant& contestant;
    std::vector<BenchAnswer> answers{};  // one a query of the course
    std::vector<BenchLane> lanes{};      // one a thread
    Preparation preparation{};
    std::uint64_t complaints = 0;
  };
  using Queries = std::vector<std::size_t>;  // by their place in the scenario

  void recall(Runner& runner);
  void make_lanes(Runner& runner, const std::vector<GivenIndex>& indexes);
  void run_pass(Runner& runner, std::uint64_t pass, BenchProgress& progress);
  bool answer_some(Runner& runner, std::span<const std::size_t> queries, BenchProgress& progress);
  bool answer(Runner& runner, unsigned worker, std::span<const std::size_t> queries);
  bool is_asked_first(std::size_t query) const;
  void complain_of(Runner& runner, const ScenarioQuery& query, const std::string& wrong);

  const Course& course_;
  const BenchSettings& settings_;
  FreeSpace space_;
  ThreadWorkers workers_;
  BenchStore& store_;
  BenchShare share_;
  std::vector<Runner> runners_;
  std::mutex complaining_;
};

}  // namespace wend::cli
