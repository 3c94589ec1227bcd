#include "bench_race.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "limit_arguments.hpp"
#include "output.hpp"

namespace wend::cli {
namespace {

constexpr std::uint64_t kMostComplaints = 5;  // of a contestant
constexpr std::size_t kQueriesAtOnce = 16;    // that a thread takes
constexpr double kSlice = 1;                  // seconds until there is a moment to do other things

}  // namespace

BenchRace::BenchRace(const Course& course, const std::vector<Contestant>& contestants,
                     unsigned threads)
    : course_(course), space_(course.map), workers_(threads) {
  for (const Contestant& contestant : contestants) {
    Runner runner{contestant, {}, {}};
    for (const ScenarioQuery& query : course.scenario.queries) {
      runner.answers.push_back({.line = query.line});
    }
    runners_.push_back(std::move(runner));
  }
}

bool BenchRace::run(std::uint64_t passes, BenchProgress& progress) {
  for (Runner& runner : runners_) {
    make_lanes(runner);
    for (BenchAnswer& answer : runner.answers) answer.seconds.reserve(passes);
  }
  for (std::uint64_t pass = 0; pass < passes; ++pass) {
    for (Runner& runner : runners_) {
      if (!run_pass(runner, pass, progress)) return false;
    }
  }
  return true;
}

std::vector<BenchRow> BenchRace::rows() const {
  std::vector<BenchRow> rows;
  for (const Runner& runner : runners_) {
    BenchRow row{.scen = course_.scenario.file,
                 .planner = runner.contestant.name(),
                 .threads = workers_.count()};
    row.set_answers(runner.answers);
    rows.push_back(std::move(row));
  }
  return rows;
}

void BenchRace::make_lanes(Runner& runner) {
  const auto complain = [this, &runner](const ScenarioQuery& query, const std::string& wrong) {
    complain_of(runner, query, wrong);
  };
  for (unsigned thread = 0; thread < workers_.count(); ++thread) {
    runner.lanes.emplace_back(runner.contestant.make_planner(space_), complain);
  }
  if (course_.scenario.queries.empty()) return;
  for (BenchLane& lane : runner.lanes) lane.warm_up(course_.scenario.queries.front());
}

bool BenchRace::run_pass(Runner& runner, std::uint64_t pass, BenchProgress& progress) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < runner.answers.size(); ++i) {
    if (runner.answers[i].seconds.size() <= pass) open.push_back(i);
  }
  while (!open.empty()) {
    if (!answer_some(runner, open, progress)) return false;
    std::erase_if(open, [&](std::size_t i) { return runner.answers[i].seconds.size() > pass; });
  }
  return true;
}

/// As many of the queries as a slice of time has room for.
bool BenchRace::answer_some(Runner& runner, std::span<const std::size_t> queries,
                            BenchProgress& progress) {
  const double end = steady_seconds() + kSlice;
  std::atomic<std::uint64_t> done = 0;
  std::atomic<bool> cancelled = false;
  const std::size_t tasks = (queries.size() + kQueriesAtOnce - 1) / kQueriesAtOnce;
  workers_.run(tasks, [&](std::size_t task, unsigned worker) {
    if (cancelled || steady_seconds() > end) return;
    const std::size_t first = task * kQueriesAtOnce;
    const auto taken = queries.subspan(first, std::min(kQueriesAtOnce, queries.size() - first));
    if (!answer(runner, worker, taken)) cancelled = true;
    done += taken.size();
    if (worker == 0) progress.bar.update(progress.done + done);
  });
  progress.done += done;
  return !cancelled;
}

/// In a worker's thread. False if Ctrl-C came.
bool BenchRace::answer(Runner& runner, unsigned worker, std::span<const std::size_t> queries) {
  BenchLane& lane = runner.lanes[worker];
  const bool timed = std::all_of(queries.begin(), queries.end(), [&](std::size_t i) {
    return lane.time(course_.scenario.queries[i], runner.answers[i]);
  });
  return lane.settle() && timed;
}

void BenchRace::complain_of(Runner& runner, const ScenarioQuery& query, const std::string& wrong) {
  const std::scoped_lock lock(complaining_);
  if (++runner.complaints <= kMostComplaints) {
    complain(fmt::format("{}:{}: {}: {}", course_.scenario.file, query.line,
                         runner.contestant.name(), wrong));
  }
  if (runner.complaints == kMostComplaints + 1) complain("... and more of these");
}

}  // namespace wend::cli
