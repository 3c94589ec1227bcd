#include "cli/developers/bench/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "cli/arguments/search_arguments.hpp"
#include "cli/interrupt.hpp"
#include "cli/output/output.hpp"

namespace wend::cli {
namespace {

constexpr std::uint64_t kMostComplaints = 5;  // of an entry
constexpr std::size_t kQueriesAtOnce = 16;    // that a thread takes
constexpr double kSlice = 1;                  // seconds between pauses for other work

}  // namespace

BenchRun::BenchRun(const BenchScenario& scenario, const std::vector<BenchEntry>& entries,
                   const BenchSettings& settings, BenchStore& store, BenchShare share)
    : scenario_(scenario),
      settings_(settings),
      space_(settings.robot.free_space(scenario.map)),
      threads_(static_cast<unsigned>(settings.threads)),
      store_(store),
      share_(share) {
  store_.begin(scenario_, space_, settings_);
  for (const BenchEntry& entry : entries) {
    runners_.push_back({entry});
    recall(runners_.back());
  }
}

void BenchRun::recall(Runner& runner) {
  BenchRecord known = store_.known(runner.entry.name());
  runner.preparation.cost = known.index;
  auto at = known.answers.begin();
  for (const ScenarioQuery& query : scenario_.queries) {
    while (at != known.answers.end() && at->line < query.line) ++at;
    const bool is_known = at != known.answers.end() && at->line == query.line;
    runner.answers.push_back(is_known ? *at : BenchAnswer{.line = query.line});
  }
}

void BenchRun::run(const std::vector<GivenIndex>& indexes, BenchProgress& progress) {
  const std::uint64_t passes = settings_.repetitions;
  for (Runner& runner : runners_) {
    std::uint64_t known = 0;
    bool all_known = true;
    for (std::size_t i = 0; i < runner.answers.size(); ++i) {
      std::vector<double>& seconds = runner.answers[i].seconds;
      known += std::min<std::uint64_t>(seconds.size(), passes);
      all_known = all_known && (seconds.size() >= passes || !share_.contains(i));
      seconds.reserve(passes);
    }
    progress.known += known;
    progress.done += known;
    if (!all_known) make_workers(runner, indexes);
  }
  for (std::uint64_t pass = 0; pass < passes; ++pass) {
    for (Runner& runner : runners_) run_pass(runner, pass, progress);
  }
}

std::vector<BenchRow> BenchRun::rows() const {
  std::vector<BenchRow> rows;
  for (const Runner& runner : runners_) {
    BenchRow row{.scen = scenario_.file,
                 .planner = runner.entry.name(),
                 .threads = threads_.count(),
                 .build_s = runner.preparation.cost.build_s,
                 .index_bytes = runner.preparation.cost.bytes};
    row.set_answers(runner.answers);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<BenchedMap> BenchRun::benched() const {
  std::vector<BenchedMap> maps;
  maps.reserve(runners_.size());
  for (const Runner& runner : runners_) {
    maps.push_back(
        {runner.entry.name(), space_.passable().count(), runner.answers, scenario_.file});
  }
  return maps;
}

void BenchRun::make_workers(Runner& runner, const std::vector<GivenIndex>& indexes) {
  const auto complain = [this, &runner](const ScenarioQuery& query, const std::string& wrong) {
    complain_of(runner, query, wrong);
  };
  runner.preparation = runner.entry.prepare(space_, indexes);
  const auto make = [this, &runner] { return runner.entry.try_make(space_, runner.preparation); };
  const WorkerRules rules{settings_.moves.moves, settings_.limit_s.value_or(0),
                          runner.entry.any_angle() ? PathKind::lines : PathKind::steps};
  for (unsigned thread = 0; thread < threads_.count(); ++thread) {
    runner.workers.emplace_back(space_, make, rules, complain);
  }
  // New planners cannot fail when this one did not.
  auto planner = runner.entry.make_planner(space_, runner.preparation);
  if (settings_.fresh) return;
  for (BenchWorker& worker : runner.workers) {
    if (!planner) planner = runner.entry.make_planner(space_, runner.preparation);
    worker.keep(std::move(planner), scenario_.queries.front());
  }
}

void BenchRun::run_pass(Runner& runner, std::uint64_t pass, BenchProgress& progress) {
  Queries open;
  for (std::size_t i = 0; i < runner.answers.size(); ++i) {
    if (share_.contains(i) && runner.answers[i].seconds.size() <= pass) open.push_back(i);
  }
  const Interruptible interruptible;  // what is answered is to be stored
  while (!open.empty()) {
    const bool cancelled = !answer_some(runner, open, progress);
    std::vector<BenchAnswer> done;
    std::erase_if(open, [&](std::size_t i) {
      const bool is_done = runner.answers[i].seconds.size() > pass;
      if (is_done) done.push_back(runner.answers[i]);
      return is_done;
    });
    store_.keep(runner.entry.name(), done, runner.preparation.cost);
    if (cancelled) throw Cancelled();
  }
}

/// Answers as many of the queries as fit into a time slice.
bool BenchRun::answer_some(Runner& runner, std::span<const std::size_t> queries,
                           BenchProgress& progress) {
  const double end = steady_seconds() + kSlice;
  std::atomic<std::uint64_t> done = 0;
  std::atomic<bool> cancelled = false;
  const std::size_t tasks = (queries.size() + kQueriesAtOnce - 1) / kQueriesAtOnce;
  threads_.run(tasks, [&](std::size_t task, unsigned thread) {
    if (cancelled || steady_seconds() > end) return;
    const std::size_t first = task * kQueriesAtOnce;
    const auto taken = queries.subspan(first, std::min(kQueriesAtOnce, queries.size() - first));
    if (!answer(runner, thread, taken)) cancelled = true;
    done += taken.size();
    if (thread == 0) progress.bar.update(progress.done + done);
  });
  progress.done += done;
  return !cancelled;
}

/// Runs in one of the threads. False if Ctrl-C came.
bool BenchRun::answer(Runner& runner, unsigned thread, std::span<const std::size_t> queries) {
  return std::all_of(queries.begin(), queries.end(), [&](std::size_t i) {
    BenchWorker& worker = runner.workers[thread];
    const ScenarioQuery& query = scenario_.queries[i];
    BenchAnswer& answer = runner.answers[i];
    if (settings_.fresh) return worker.time_fresh(query, answer);
    const bool first = is_asked_first(i) && answer.seconds.empty();
    return (!first || worker.time_first(query, answer)) && worker.time_later(query, answer);
  });
}

/// A few queries, evenly spread, show what a first query takes.
bool BenchRun::is_asked_first(std::size_t query) const {
  constexpr std::size_t kAskedFirst = 10;
  const std::size_t all = scenario_.queries.size();
  if (all <= kAskedFirst) return true;
  const std::size_t nth = query * kAskedFirst / all;
  return query == (2 * nth + 1) * all / (2 * kAskedFirst);
}

void BenchRun::complain_of(Runner& runner, const ScenarioQuery& query, const std::string& wrong) {
  const std::scoped_lock lock(complaining_);
  if (++runner.complaints <= kMostComplaints) {
    complain(fmt::format("{}:{}: {}: {}", scenario_.file, query.line, runner.entry.name(), wrong));
  }
  if (runner.complaints == kMostComplaints + 1) complain("... and more");
}

}  // namespace wend::cli
