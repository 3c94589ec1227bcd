// wend bench: MovingAI scenarios, solved, timed and checked.

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include "command.hpp"
#include "exit_code.hpp"
#include "flags.hpp"
#include "interrupt.hpp"
#include "limit_arguments.hpp"
#include "output.hpp"
#include "planner_argument.hpp"
#include "progress_bar.hpp"
#include "wend/io/load_map.hpp"
#include "wend/io/scenario.hpp"
#include "wend/planner/planner.hpp"
#include "wend/report/bench_rows.hpp"
#include "wend/report/scenario_verdict.hpp"

namespace wend::cli {
namespace {

struct BenchArguments {
  std::vector<std::string> scenarios;
  std::string planners = "astar";
  std::string map;
  bool check = false;
  Format format = Format::text;
};

constexpr std::uint64_t kMostComplaints = 5;  // a row

constexpr const char* kExamples = R"(Examples:
  wend bench arena.map.scen
  wend bench arena.map.scen den520d.map.scen --planner astar,dijkstra --check
  wend bench arena.map.scen --planner astar:weight=2 --format json
  wend bench queries.scen --map arena.map

Always 8 neighbours without corner cutting. The map of X.map.scen is X.map, of other
scenarios the name in their map column; it lies in the scenario's folder. Wrong is: no path
though the file gives a length; a path though it says there is none; another length; with
--check, a path that is not valid cell by cell. Exit codes: 0 all right, 1 something is
wrong, 2 bad usage or input.)";

/// A scenario and the map that it is for.
struct Course {
  Scenario scenario;
  GridMap map;
};

/// Ctrl-C, thrown out of the loops.
class Cancelled : public std::exception {};

template <class T>
T value_or_throw(Expected<T, IoError> result) {
  if (!result) throw InputError(result.error().message());
  return *std::move(result);
}

Course load_course(const std::string& file, const std::string& map_file) {
  Scenario scenario = value_or_throw(load_scenario(file));
  const auto map_path = map_file.empty() ? value_or_throw(scenario_map_path(scenario))
                                         : std::filesystem::path(map_file);
  LoadedMap loaded = value_or_throw(load_map(map_path));
  const auto fits = check_map_size(scenario, loaded.map.width(), loaded.map.height());
  if (!fits) throw InputError(fits.error().message());
  return {std::move(scenario), std::move(loaded.map)};
}

std::unique_ptr<Planner> make_planner_for(const PlannerSpec& spec, const FreeSpace& space) {
  auto planner = info_of(spec).make(space, spec.options);
  if (!planner) throw InputError(fmt::format("{}: {}", spec.text, planner.error().message()));
  return *std::move(planner);
}

/// Scenarios say how to move; lengths of other moves would all be wrong.
void refuse_moves(const PlannerSpec& spec) {
  if (info_of(spec).motion != Motion::cells) {
    throw InputError(fmt::format(
        "{}: scenarios are for planners that move from cell to cell, and this one drives a car",
        spec.text));
  }
  if (moves_of(spec) == GridMoves{}) return;
  throw InputError(fmt::format(
      "{}: scenarios are always run on 8 neighbours without corner cutting", spec.text));
}

/// One planner on one scenario.
class BenchRun {
 public:
  BenchRun(const Scenario& scenario, const FreeSpace& space, const PlannerSpec& spec, bool check)
      : scenario_(scenario), check_(check), planner_(make_planner_for(spec, space)) {
    row_.scen = scenario.file;
    row_.planner = spec.text;
  }

  BenchRow run(ProgressBar& progress, std::uint64_t& done) {
    std::vector<double> microseconds;
    microseconds.reserve(scenario_.queries.size());
    warm_up();
    for (const ScenarioQuery& query : scenario_.queries) {
      microseconds.push_back(answer(query));
      progress.update(++done);
    }
    row_.set_work(std::move(microseconds), expanded_);
    return std::move(row_);
  }

 private:
  /// The first query pays for fresh memory; that is not to be measured.
  void warm_up() {
    if (!scenario_.queries.empty()) planner_->plan(query_for(scenario_.queries.front()), plan_);
  }

  Query query_for(const ScenarioQuery& query) const {
    Query asked = Query::between(query.start, query.goal);
    asked.limits.cancel = &cancelled_;
    return asked;
  }

  /// Plans and checks; the microseconds that planning took.
  double answer(const ScenarioQuery& query) {
    const Query asked = query_for(query);
    const double begin = steady_seconds();
    const Status status = planner_->plan(asked, plan_);
    const double end = steady_seconds();
    if (cancelled_) throw Cancelled();
    ++row_.queries;
    row_.solved += status == Status::found ? 1 : 0;
    expanded_ += plan_.metrics.expanded;
    judge(query, status);
    return (end - begin) * 1e6;
  }

  void judge(const ScenarioQuery& query, Status status) {
    std::string wrong = wrong_answer(query, status, plan_);
    if (wrong.empty() && check_ && status == Status::found) {
      wrong = wrong_path(planner_->free_space(), query, plan_.path);
    }
    if (wrong.empty()) return;
    if (++row_.wrong <= kMostComplaints) {
      complain(fmt::format("{}:{}: {}: {}", row_.scen, query.line, row_.planner, wrong));
    }
    if (row_.wrong == kMostComplaints + 1) complain("... and more of these");
  }

  const Scenario& scenario_;
  bool check_;
  const std::atomic<bool>& cancelled_ = cancel_on_interrupt();
  std::unique_ptr<Planner> planner_;
  Plan plan_;
  BenchRow row_;
  std::uint64_t expanded_ = 0;
};

std::vector<BenchRow> run_all(const std::vector<Course>& courses,
                              const std::vector<PlannerSpec>& planners, bool check) {
  std::uint64_t queries = 0;
  for (const Course& course : courses) queries += course.scenario.queries.size();
  ProgressBar progress("queries", queries * planners.size());
  std::uint64_t done = 0;
  std::vector<BenchRow> rows;
  for (const Course& course : courses) {
    const FreeSpace space(course.map);
    for (const PlannerSpec& spec : planners) {
      rows.push_back(BenchRun(course.scenario, space, spec, check).run(progress, done));
    }
  }
  return rows;
}

int run(const BenchArguments& arguments) {
  const std::vector<PlannerSpec> planners = parse_planners(arguments.planners);
  for (const PlannerSpec& spec : planners) refuse_moves(spec);
  std::vector<Course> courses;
  courses.reserve(arguments.scenarios.size());
  for (const std::string& file : arguments.scenarios) {
    courses.push_back(load_course(file, arguments.map));
  }
  try {
    const std::vector<BenchRow> rows = run_all(courses, planners, arguments.check);
    print(arguments.format == Format::json ? bench_json(rows) : bench_table(rows));
    const auto is_wrong = [](const BenchRow& row) { return row.wrong > 0; };
    return std::any_of(rows.begin(), rows.end(), is_wrong) ? no_plan : success;
  } catch (const Cancelled&) {
    complain("cancelled");
    return no_plan;
  }
}

}  // namespace

Command add_bench(CLI::App& app) {
  CLI::App& bench = *app.add_subcommand("bench", "Solve, time and check MovingAI scenarios");
  const auto arguments = std::make_shared<BenchArguments>();
  bench.add_option("SCEN", arguments->scenarios, "MovingAI scenarios")
      ->required()
      ->type_name(kFileType);
  bench
      .add_option("--planner", arguments->planners,
                  wrapped("Planners with commas between, options after a colon: "
                          "astar:weight=2,dijkstra (default astar)"))
      ->type_name(kPlannerType);
  bench.add_option("--map", arguments->map, "The map, for all scenarios")->type_name(kFileType);
  bench.add_flag("--check", arguments->check, "Check every path cell by cell as well");
  add_format(bench, arguments->format);
  bench.footer(kExamples);
  return {&bench, [arguments] { return run(*arguments); }};
}

}  // namespace wend::cli
