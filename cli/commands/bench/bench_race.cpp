#include "cli/commands/bench/bench_race.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "cli/arguments/limit_arguments.hpp"
#include "cli/interrupt.hpp"
#include "cli/output/output.hpp"

namespace wend::cli {
namespace {

constexpr std::uint64_t kMostComplaints = 5;  // of a contestant
constexpr std::size_t kQueriesAtOnce = 16;    // that a thread takes
constexpr double kSlice = 1;                  // seconds until there is a moment to do other things

}  // namespace

BenchRace::BenchRace(const Course& course, const std::vector<Contestant>& contestants,
                     const BenchSettings& settings, BenchStore& store, BenchShare share)
    : course_(course),
      settings_(settings),
      space_(settings.robot.free_space(course.map)),
      workers_(static_cast<unsigned>(settings.threads)),
      store_(store),
      share_(share) {
  store_.begin(course_, space_, settings_);
  for (const Contestant& contestant : contestants) {
    runners_.push_back({contestant});
    recall(runners_.back());
  }
}

void BenchRace::recall(Runner& runner) {
  BenchRecord known = store_.known(runner.contestant.name());
  runner.preparation.cost = known.index;
  auto at = known.answers.begin();
  for (const ScenarioQuery& query : course_.scenario.queries) {
    while (at != known.answers.end() && at->line < query.line) ++at;
    const bool is_known = at != known.answers.end() && at->line == query.line;
    runner.answers.push_back(is_known ? *at : BenchAnswer{.line = query.line});
  }
}

void BenchRace::run(const std::vector<GivenIndex>& indexes, BenchProgress& progress) {
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
                 .build_s = runner.preparation.cost.build_s,
                 .index_bytes = runner.preparation.cost.bytes};
    row.set_answers(runner.answers);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<BenchedMap> BenchRace::benched() const {
  std::vector<BenchedMap> maps;
  maps.reserve(runners_.size());
  for (const Runner& runner : runners_) {
    maps.push_back({runner.contestant.name(), space_.passable().count(), runner.answers,
                    course_.scenario.file});
  }
  return maps;
}

void BenchRace::make_lanes(Runner& runner, const std::vector<GivenIndex>& indexes) {
  const auto complain = [this, &runner](const ScenarioQuery& query, const std::string& wrong) {
    complain_of(runner, query, wrong);
  };
  runner.preparation = runner.contestant.prepare(space_, indexes);
  const auto make = [this, &runner] {
    return runner.contestant.try_make(space_, runner.preparation);
  };
  const LaneRules rules{settings_.moves.moves, settings_.limit_s.value_or(0)};
  for (unsigned thread = 0; thread < workers_.count(); ++thread) {
    runner.lanes.emplace_back(space_, make, rules, complain);
  }
  // New planners cannot fail when this one did not.
  auto planner = runner.contestant.make_planner(space_, runner.preparation);
  if (settings_.fresh) return;
  for (BenchLane& lane : runner.lanes) {
    if (!planner) planner = runner.contestant.make_planner(space_, runner.preparation);
    lane.keep(std::move(planner), course_.scenario.queries.front());
  }
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
    store_.keep(runner.contestant.name(), done, runner.preparation.cost);
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
  return std::all_of(queries.begin(), queries.end(), [&](std::size_t i) {
    BenchLane& lane = runner.lanes[worker];
    const ScenarioQuery& query = course_.scenario.queries[i];
    BenchAnswer& answer = runner.answers[i];
    if (settings_.fresh) return lane.time_fresh(query, answer);
    const bool first = is_asked_first(i) && answer.seconds.empty();
    return (!first || lane.time_first(query, answer)) && lane.time_later(query, answer);
  });
}

/// A few queries, evenly spread, show what a first query takes.
bool BenchRace::is_asked_first(std::size_t query) const {
  constexpr std::size_t kAskedFirst = 10;
  const std::size_t all = course_.scenario.queries.size();
  if (all <= kAskedFirst) return true;
  const std::size_t nth = query * kAskedFirst / all;
  return query == (2 * nth + 1) * all / (2 * kAskedFirst);
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
