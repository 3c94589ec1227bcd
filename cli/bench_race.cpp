#include "bench_race.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "interrupt.hpp"
#include "limit_arguments.hpp"
#include "output.hpp"

namespace wend::cli {
namespace {

constexpr std::uint64_t kMostComplaints = 5;  // of a contestant
constexpr std::size_t kQueriesAtOnce = 16;    // that a thread takes
constexpr double kSlice = 1;                  // seconds until there is a moment to do other things

}  // namespace

BenchRace::BenchRace(const Course& course, const std::vector<Contestant>& contestants,
                     unsigned threads, BenchStore& store, BenchShare share)
    : course_(course), space_(course.map), workers_(threads), store_(store), share_(share) {
  store_.begin(course_, space_, workers_.count());
  for (const Contestant& contestant : contestants) {
    runners_.push_back({contestant});
    recall(runners_.back());
  }
}

void BenchRace::recall(Runner& runner) {
  BenchRecord known = store_.known(runner.contestant.name());
  runner.index = known.index;
  auto at = known.answers.begin();
  for (const ScenarioQuery& query : course_.scenario.queries) {
    while (at != known.answers.end() && at->line < query.line) ++at;
    const bool is_known = at != known.answers.end() && at->line == query.line;
    runner.answers.push_back(is_known ? *at : BenchAnswer{.line = query.line});
  }
}

void BenchRace::run(std::uint64_t passes, const std::vector<GivenIndex>& indexes,
                    BenchProgress& progress) {
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
    if (!all_known) make_lanes(runner, indexes);
  }
  for (std::uint64_t pass = 0; pass < passes; ++pass) {
    for (Runner& runner : runners_) run_pass(runner, pass, progress);
  }
}

std::vector<BenchRow> BenchRace::rows() const {
  std::vector<BenchRow> rows;
  for (const Runner& runner : runners_) {
    BenchRow row{.scen = course_.scenario.file,
                 .planner = runner.contestant.name(),
                 .threads = workers_.count(),
                 .build_s = runner.index.build_s,
                 .index_bytes = runner.index.bytes};
    row.set_answers(runner.answers);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<BenchedMap> BenchRace::benched() const {
  std::vector<BenchedMap> maps;
  maps.reserve(runners_.size());
  for (const Runner& runner : runners_) {
    maps.push_back({runner.contestant.name(), space_.passable().count(), runner.answers});
  }
  return maps;
}

void BenchRace::make_lanes(Runner& runner, const std::vector<GivenIndex>& indexes) {
  const auto complain = [this, &runner](const ScenarioQuery& query, const std::string& wrong) {
    complain_of(runner, query, wrong);
  };
  const Preparation preparation = runner.contestant.prepare(space_, indexes, workers_);
  runner.index = preparation.cost;
  for (unsigned thread = 0; thread < workers_.count(); ++thread) {
    runner.lanes.emplace_back(runner.contestant.make_planner(space_, preparation), complain);
  }
  for (BenchLane& lane : runner.lanes) lane.warm_up(course_.scenario.queries.front());
}

void BenchRace::run_pass(Runner& runner, std::uint64_t pass, BenchProgress& progress) {
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
    store_.keep(runner.contestant.name(), done, runner.index);
    if (cancelled) throw Cancelled();
  }
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
