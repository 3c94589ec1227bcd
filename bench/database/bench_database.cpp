#include "bench/database/bench_database.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "bench/database/bench_schema.hpp"
#include "bench/database/sqlite.hpp"
#include "wend/base/status.hpp"

namespace wend {
namespace {

/// Of a scenario: more do not fit into a file.
constexpr std::size_t kLastLine = std::numeric_limits<std::int32_t>::max();

/// An experiment's setup in Planner Arena; with the other columns it identifies the experiment.
std::string setup_of(const BenchExperiment& experiment) {
  return fmt::format("scenario {}\nfingerprint {:016x}\n{}\ncommit {}\n", experiment.scenario,
                     experiment.fingerprint, experiment.conditions, experiment.commit);
}

/// "astar:weight=2" as OMPL's scripts write settings: a line each, and a semicolon.
std::string settings_of(std::string_view spec) {
  std::string settings = "planner = ";
  bool first = true;
  for (const char letter : spec) {
    const bool next = letter == (first ? ':' : ',');
    if (!next) {
      settings += letter == '=' ? std::string(" = ") : std::string(1, letter);
      continue;
    }
    settings += "\n;";
    first = false;
  }
  return settings + "\n;";
}

Error error_of(const std::filesystem::path& file, const std::string& what) {
  return file_error(file.string(), 0, what);
}

/// Removes answers that are known with at least as many repetitions. Both are sorted by line.
void forget_known(std::vector<BenchAnswer>& answers, std::span<const BenchAnswer> known) {
  auto at = known.begin();
  std::erase_if(answers, [&](const BenchAnswer& answer) {
    while (at != known.end() && at->line < answer.line) ++at;
    return at != known.end() && at->line == answer.line &&
           at->seconds.size() >= answer.seconds.size();
  });
}

/// Reads the progress of answers, which are sorted by line.
void recall_progress(SqliteConnection& connection, std::int64_t experiment, std::int64_t planner,
                     std::vector<BenchAnswer>& answers) {
  SqliteStatement rows(
      connection,
      "SELECT line, progress.time, best_cost FROM runs INNER JOIN progress ON progress.runid = "
      "runs.id WHERE experimentid = ? AND plannerid = ? ORDER BY line, progress.time");
  auto at = answers.begin();
  for (rows.start(experiment, planner); rows.next();) {
    const auto line = static_cast<std::size_t>(rows.integer(0));
    while (at != answers.end() && at->line < line) ++at;
    if (at != answers.end() && at->line == line) {
      at->progress.push_back({rows.number(1), rows.number(2)});
    }
  }
}

bool is_time(double seconds) { return seconds >= 0 && std::isfinite(seconds); }

/// What no benchmark has stored, but a file may say. Values of SQLite have any type.
std::string fault_of(const BenchAnswer& answer) {
  if (answer.line > kLastLine) return "there is no such line";
  if (!is_time(answer.length)) return "its length is negative or not finite";
  bool times = std::ranges::all_of(answer.seconds, is_time);
  if (answer.first)
    times = times && is_time(answer.first->prepare_s) && is_time(answer.first->seconds);
  double before = 0;
  for (const BenchSolution& solution : answer.progress) {
    times = times && is_time(solution.seconds) && solution.seconds >= before;
    before = solution.seconds;
    if (!is_time(solution.cost)) return "a cost in its progress is negative or not finite";
  }
  return times ? "" : "one of its times is negative or not finite";
}

/// What is wrong with a planner's answers; empty if nothing is.
std::string fault_of(const BenchRecord& record) {
  if (!is_time(record.index.build_s)) return "the time to build an index is negative or not finite";
  for (const BenchAnswer& answer : record.answers) {
    const std::string fault = fault_of(answer);
    if (!fault.empty()) return fmt::format("the answer to line {}: {}", answer.line, fault);
  }
  return {};
}

std::optional<double> first_of(const BenchAnswer& answer, double FirstQuery::* time) {
  return answer.first ? std::optional((*answer.first).*time) : std::nullopt;
}

}  // namespace

BenchDatabase::BenchDatabase(std::filesystem::path file,
                             std::unique_ptr<SqliteConnection> connection)
    : file_(std::move(file)), connection_(std::move(connection)) {}
BenchDatabase::~BenchDatabase() = default;
BenchDatabase::BenchDatabase(BenchDatabase&&) noexcept = default;
BenchDatabase& BenchDatabase::operator=(BenchDatabase&&) noexcept = default;

Expected<BenchDatabase, Error> BenchDatabase::open(const std::filesystem::path& file) {
  auto connection = std::make_unique<SqliteConnection>(file);
  const std::string wrong = prepare_bench_schema(*connection);
  if (!wrong.empty()) return Unexpected<Error>(error_of(file, wrong));
  return BenchDatabase(file, std::move(connection));
}

Expected<std::int64_t, Error> BenchDatabase::experiment(const BenchExperiment& experiment) {
  SqliteTransaction transaction(*connection_);
  const auto threads = static_cast<std::int64_t>(experiment.threads);
  SqliteStatement find(*connection_,
                       "SELECT id FROM experiments WHERE name = ? AND version = ? AND threads = ? "
                       "AND cpuinfo = ? AND setup = ? AND timelimit = ?");
  if (find.run(experiment.map, experiment.version, threads, experiment.machine,
               setup_of(experiment), experiment.limit_s)) {
    return find.integer(0);
  }
  SqliteStatement add(
      *connection_,
      "INSERT INTO experiments (name, totaltime, timelimit, memorylimit, runcount, version, "
      "hostname, cpuinfo, date, seed, setup, map_width, map_height, free_cells, threads, scenario, "
      "fingerprint, commit_hash, conditions) "
      "VALUES (?, 0, ?, 0, 0, ?, ?, ?, datetime('now'), '0', ?, ?, ?, ?, ?, ?, ?, ?, ?) "
      "RETURNING id");
  const bool added = add.run(
      experiment.map, experiment.limit_s, experiment.version, experiment.host, experiment.machine,
      setup_of(experiment), std::int64_t{experiment.width}, std::int64_t{experiment.height},
      static_cast<std::int64_t>(experiment.free_cells), threads, experiment.scenario,
      static_cast<std::int64_t>(experiment.fingerprint), experiment.commit, experiment.conditions);
  const std::int64_t id = added ? add.integer(0) : 0;
  add.next();  // to its end
  transaction.commit();
  if (!ok()) return failure();
  return id;
}

Expected<std::int64_t, Error> BenchDatabase::planner(std::string_view spec) {
  SqliteTransaction transaction(*connection_);
  SqliteStatement find(*connection_, "SELECT id FROM plannerConfigs WHERE name = ?");
  if (find.run(std::string(spec))) return find.integer(0);
  SqliteStatement add(*connection_,
                      "INSERT INTO plannerConfigs (name, settings) VALUES (?, ?) RETURNING id");
  const std::int64_t id = add.run(std::string(spec), settings_of(spec)) ? add.integer(0) : 0;
  add.next();
  transaction.commit();
  if (!ok()) return failure();
  return id;
}

Expected<BenchRecord, Error> BenchDatabase::record(std::int64_t experiment,
                                                   std::int64_t planner) const {
  const auto damaged = [&](const std::string& fault) {
    return Unexpected<Error>(error_of(file_, "the database is damaged: " + fault));
  };
  BenchRecord record;
  SqliteStatement runs(
      *connection_,
      "SELECT runs.id, line, status, solution_length, expanded, correct_solution, build_s, "
      "index_bytes, passes.time, prepare_s, first_s FROM runs INNER JOIN passes ON passes.runid = "
      "runs.id "
      "WHERE experimentid = ? AND plannerid = ? ORDER BY line, passes.pass");
  std::int64_t last = -1;
  for (runs.start(experiment, planner); runs.next();) {
    if (runs.integer(0) != last) {
      last = runs.integer(0);
      const std::int64_t status = runs.integer(2);
      if (status < 0 || status >= kStatuses)
        return damaged(fmt::format("there is no status {}", status));
      record.answers.push_back({.line = static_cast<std::size_t>(runs.integer(1)),
                                .status = static_cast<Status>(status),
                                .length = runs.number(3),
                                .expanded = static_cast<std::uint64_t>(runs.integer(4)),
                                .wrong = runs.integer(5) == 0});
      if (runs.has(10)) record.answers.back().first = {runs.number(9), runs.number(10)};
      record.index = {runs.number(6), static_cast<std::uint64_t>(runs.integer(7))};
    }
    record.answers.back().seconds.push_back(runs.number(8));
  }
  recall_progress(*connection_, experiment, planner, record.answers);
  if (!ok()) return failure();
  if (const std::string fault = fault_of(record); !fault.empty()) {
    return damaged(fault);
  }
  return record;
}

Expected<void, Error> BenchDatabase::store(std::int64_t experiment, std::int64_t planner,
                                           std::span<const BenchAnswer> answers,
                                           const BenchIndex& index) {
  SqliteTransaction transaction(*connection_);
  SqliteStatement forget(*connection_,
                         "DELETE FROM runs WHERE experimentid = ? AND plannerid = ? AND line = ?");
  SqliteStatement add(
      *connection_,
      "INSERT INTO runs (experimentid, plannerid, time, solved, status, solution_length, "
      "correct_solution, expanded, build_s, index_bytes, prepare_s, first_s, line) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) RETURNING id");
  SqliteStatement add_pass(*connection_, "INSERT INTO passes (runid, pass, time) VALUES (?, ?, ?)");
  // Two paths at one reading of the clock are one row, of the better path.
  SqliteStatement add_progress(
      *connection_, "INSERT OR REPLACE INTO progress (runid, time, best_cost) VALUES (?, ?, ?)");
  for (const BenchAnswer& answer : answers) {
    const auto line = static_cast<std::int64_t>(answer.line);
    forget.run(experiment, planner, line);
    add.run(experiment, planner, answer.fastest(), std::int64_t{answer.found()},
            static_cast<std::int64_t>(answer.status), answer.length, std::int64_t{!answer.wrong},
            static_cast<std::int64_t>(answer.expanded), index.build_s,
            static_cast<std::int64_t>(index.bytes), first_of(answer, &FirstQuery::prepare_s),
            first_of(answer, &FirstQuery::seconds), line);
    const std::int64_t run = ok() ? add.integer(0) : 0;
    add.next();
    std::int64_t pass = 0;
    for (const double seconds : answer.seconds) add_pass.run(run, ++pass, seconds);
    for (const auto& [seconds, cost] : answer.progress) add_progress.run(run, seconds, cost);
  }
  SqliteStatement sum_up(*connection_, kSumUpExperiment);
  sum_up.run(experiment);
  transaction.commit();
  if (!ok()) return failure();
  return {};
}

Expected<void, Error> BenchDatabase::merge(const BenchDatabase& other) {
  for (const auto& [their_experiment, described] : other.experiments()) {
    const auto our_experiment = experiment(described);
    if (!our_experiment) return Unexpected<Error>(our_experiment.error());
    for (const auto& [their_planner, spec] : other.planners()) {
      const auto our_planner = planner(spec);
      if (!our_planner) return Unexpected<Error>(our_planner.error());
      auto theirs = other.record(their_experiment, their_planner);
      if (!theirs) return Unexpected<Error>(theirs.error());
      const auto ours = record(*our_experiment, *our_planner);
      if (!ours) return Unexpected<Error>(ours.error());
      forget_known(theirs->answers, ours->answers);
      if (theirs->answers.empty()) continue;
      auto stored = store(*our_experiment, *our_planner, theirs->answers, theirs->index);
      if (!stored) return stored;
    }
  }
  if (!other.ok()) return other.failure();
  return {};
}

std::vector<std::pair<std::int64_t, BenchExperiment>> BenchDatabase::experiments() const {
  std::vector<std::pair<std::int64_t, BenchExperiment>> all;
  SqliteStatement rows(*connection_,
                       "SELECT id, name, map_width, map_height, free_cells, scenario, fingerprint, "
                       "threads, version, hostname, cpuinfo, commit_hash, conditions, timelimit "
                       "FROM experiments ORDER BY id");
  for (rows.start(); rows.next();) {
    all.emplace_back(rows.integer(0),
                     BenchExperiment{.map = rows.text(1),
                                     .width = static_cast<int>(rows.integer(2)),
                                     .height = static_cast<int>(rows.integer(3)),
                                     .free_cells = static_cast<std::uint64_t>(rows.integer(4)),
                                     .scenario = rows.text(5),
                                     .fingerprint = static_cast<std::uint64_t>(rows.integer(6)),
                                     .threads = static_cast<unsigned>(rows.integer(7)),
                                     .version = rows.text(8),
                                     .commit = rows.text(11),
                                     .conditions = rows.text(12),
                                     .limit_s = rows.number(13),
                                     .host = rows.text(9),
                                     .machine = rows.text(10)});
  }
  return all;
}

std::vector<std::pair<std::int64_t, std::string>> BenchDatabase::planners() const {
  std::vector<std::pair<std::int64_t, std::string>> all;
  SqliteStatement rows(*connection_, "SELECT id, name FROM plannerConfigs ORDER BY id");
  for (rows.start(); rows.next();) all.emplace_back(rows.integer(0), rows.text(1));
  return all;
}

bool BenchDatabase::ok() const { return connection_->ok(); }

Unexpected<Error> BenchDatabase::failure() const {
  return Unexpected<Error>(error_of(file_, connection_->error()));
}

}  // namespace wend
