#pragma once

// BenchRun: runs all entries on one scenario, one after another, repetition after repetition.

#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "bench/scenario/bench_plot.hpp"
#include "bench/scenario/bench_rows.hpp"
#include "cli/developers/bench/entry.hpp"
#include "cli/developers/bench/scenarios.hpp"
#include "cli/developers/bench/settings.hpp"
#include "cli/developers/bench/store.hpp"
#include "cli/developers/bench/worker.hpp"
#include "cli/output/progress_bar.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/robot/free_space.hpp"

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

/// Progress of all runs.
struct BenchProgress {
  ProgressBar bar;
  std::uint64_t done = 0;   // queries, of every entry and repetition
  std::uint64_t known = 0;  // those of them that the store had
};

class BenchRun {
 public:
  /// Queries that the store knows count as answered. All arguments must outlive this.
  BenchRun(const BenchScenario& scenario, const std::vector<BenchEntry>& entries,
           const BenchSettings& settings, BenchStore& store, BenchShare share = {});

  /// Asks every entry every query of the share until it has all repetitions. Throws Cancelled if
  /// Ctrl-C came: what was answered until then is stored. Throws InputError if an entry does not
  /// take its options or the map.
  void run(const std::vector<GivenIndex>& indexes, BenchProgress& progress);

  /// The results, one row per entry; only for the whole scenario.
  std::vector<BenchRow> rows() const;

  /// The same with every answer, for plots.
  std::vector<BenchedMap> benched() const;

 private:
  struct Runner {
    const BenchEntry& entry;
    std::vector<BenchAnswer> answers{};  // one a query of the scenario
    std::vector<BenchWorker> workers{};  // one a thread
    Preparation preparation{};
    std::uint64_t complaints = 0;
  };
  using Queries = std::vector<std::size_t>;  // by their place in the scenario

  void recall(Runner& runner);
  void make_workers(Runner& runner, const std::vector<GivenIndex>& indexes);
  void run_pass(Runner& runner, std::uint64_t pass, BenchProgress& progress);
  bool answer_some(Runner& runner, std::span<const std::size_t> queries, BenchProgress& progress);
  bool answer(Runner& runner, unsigned thread, std::span<const std::size_t> queries);
  bool is_asked_first(std::size_t query) const;
  void complain_of(Runner& runner, const ScenarioQuery& query, const std::string& wrong);

  const BenchScenario& scenario_;
  const BenchSettings& settings_;
  FreeSpace space_;
  ThreadWorkers threads_;
  BenchStore& store_;
  BenchShare share_;
  std::vector<Runner> runners_;
  std::mutex complaining_;
};

}  // namespace wend::cli
