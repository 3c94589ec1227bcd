// wend field: the cost to one goal, or to the nearest of several, from everywhere.

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/option_flags.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/explanations.hpp"
#include "cli/output/field_text.hpp"
#include "cli/output/output.hpp"
#include "cli/output/plan_text.hpp"
#include "cli/output/terminal.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/report/analysis_report.hpp"

namespace wend::cli {
namespace {

struct FieldArguments {
  MapArguments map;
  std::vector<std::string> goals;
  std::vector<std::string> starts;
  OptionFlags options{"field"};
  LimitArguments limits;
  bool grid = false;
  bool times = false;
  Format format = Format::text;
  OutputFiles output;
};

constexpr const char* kFieldExamples = R"(Examples:
  wend field grid.txt --goal 9,9
  wend field grid.txt --goal 9,9 --start 0,0 --start 0,9
  wend field office.yaml --goal 15,9 --start 1,1 --format json
  wend field grid.txt --goal 0,0 --goal 9,9 -o field.csv

One search from the goal computes the cost to the goal for every cell, the best
path from each start, and the policy: the move to make in every cell. Small maps
show both. Exit codes: 0 there is a path from every start, 1 there is not
(standard error gives the reason), 2 bad usage or input.)";

/// One field, from the arguments to its report.
class FieldRun {
 public:
  /// `times` are those of the work done for it so far.
  FieldRun(const FieldArguments& arguments, GridMoves moves, FreeSpace space,
           const WorkTimes& times)
      : arguments_(arguments),
        moves_(moves),
        space_(std::move(space)),
        coordinates_(arguments.map.coordinates(space_.map())),
        explainer_(explainer_for(space_, coordinates_, moves_)) {
    for (const auto& typed : arguments.goals) goals_.push_back(coordinates_.parse("goal", typed));
    for (const auto& typed : arguments.starts) {
      starts_.push_back(coordinates_.parse("start", typed));
    }
    for (const Place& goal : goals_) report_.goals.push_back(goal.cell);
    report_.times = times;
  }

  void make();
  ExitCode report() const;

 private:
  void take_path(const CostToGo& field, const Place& start);
  std::string explain_goals(const Limits& limits, const SearchMetrics& metrics) const;
  std::string explain_start(Status status, const Place& start) const;
  void write_files() const;
  std::string json() const;

  const FieldArguments& arguments_;
  GridMoves moves_;
  FreeSpace space_;
  Coordinates coordinates_;
  Explainer explainer_;
  std::vector<Place> goals_;
  std::vector<Place> starts_;
  std::optional<CostToGo> field_;
  FieldReport report_;
};

void FieldRun::make() {
  ProgressBar progress("costs", space_.passable().count());
  const Limits limits = arguments_.limits.limits(progress);
  auto field = timed(thread_cpu_seconds, report_.times.search,
                     [&] { return CostToGo::make(space_, report_.goals, moves_, limits); });
  if (!field) {
    report_.status = field.error().status;
    report_.metrics = field.error().metrics;
    report_.reason = explain_goals(limits, report_.metrics);
    return;
  }
  const CostToGo& made = field_.emplace(*std::move(field));
  report_.metrics = made.metrics();
  for (const Place& start : starts_) take_path(made, start);
}

void FieldRun::take_path(const CostToGo& field, const Place& start) {
  auto plan = field.path_from(start.cell);
  FieldStart from{start.cell, {}};
  if (plan) {
    from.result.plan = *std::move(plan);
  } else {
    from.result.status = plan.error().status;
    from.result.reason = explain_start(plan.error().status, start);
  }
  report_.starts.push_back(std::move(from));
}

std::string FieldRun::explain_goals(const Limits& limits, const SearchMetrics& metrics) const {
  for (const Place& goal : goals_) {
    const std::string text = explainer_.blocked(goal);
    if (!text.empty()) return text;
  }
  return explainer_.stopped(report_.status, limits, metrics);
}

std::string FieldRun::explain_start(Status status, const Place& start) const {
  if (status != Status::unreachable) return explainer_.blocked(start);
  const auto component = [this](const Place& place) {
    return coordinates_.area(component_size(space_, place.cell, moves_));
  };
  return fmt::format(
      "there is no path from start {} to {}: the start's connected component has {}, the goal's "
      "has {}",
      start.text, goals_.size() == 1 ? "goal " + goals_[0].text : "any goal", component(start),
      component(goals_[0]));
}

std::string FieldRun::json() const {
  const bool with_grid = arguments_.grid && field_;
  return field_json(report_, space_.map().frame(), with_grid ? &*field_ : nullptr);
}

void FieldRun::write_files() const {
  std::map<std::string, FileWriter> writers{
      {".json", [&](const std::string& file) { return write_bytes(file, json()); }}};
  if (field_) {
    writers[".csv"] = [&](const std::string& file) {
      return write_bytes(file, field_csv(*field_, space_.map().frame()));
    };
  }
  arguments_.output.write(writers, arguments_.format == Format::json ? ".json" : ".csv");
}

ExitCode FieldRun::report() const {
  if (arguments_.output.print()) {
    // write_files() prints
  } else if (arguments_.format == Format::json) {
    print(json());
  } else if (field_) {
    print(field_text(*field_, space_, report_, detect_screen()) +
          (arguments_.times ? times_lines(report_.times) : ""));
  }
  write_files();
  ExitCode code = success;
  const auto fail = [&code](Status status, const std::string& reason) {
    if (status == Status::found) return;
    complain(reason);
    code = no_plan;
  };
  fail(report_.status, report_.reason);
  for (const FieldStart& start : report_.starts) fail(start.result.status, start.result.reason);
  return code;
}

int run(const FieldArguments& arguments) {
  arguments.output.check();
  const auto moves = parse_options<GridMoves>(arguments.options.values_for("field"));
  if (!moves) throw InputError(moves.error().message);
  WorkTimes times;
  const LoadedMap loaded =
      timed(thread_cpu_seconds, times.load, [&] { return arguments.map.load_map(); });
  arguments.output.check_not_among(loaded.files);
  const FreeSpace space = timed(thread_cpu_seconds, times.free_space,
                                [&] { return arguments.map.free_space(loaded.map); });
  FieldRun run(arguments, *moves, space, times);
  run.make();
  return run.report();
}

}  // namespace

Command add_field(Parser& app) {
  Parser field = app.add_subcommand("field", "Compute cost and move to a goal for every cell");
  const auto arguments = std::make_shared<FieldArguments>();
  arguments->map.add_to(field);
  arguments->map.add_clearance_cost_to(field);
  add_texts(
      field, "--goal", arguments->goals,
      "Goal: metres or cells as in `wend plan`; if given several times, the nearest goal counts")
      .required()
      .type_name("X,Y");
  add_texts(field, "--start", arguments->starts,
            "Print the best path from this start; may be given several times")
      .type_name("X,Y");
  field.add_flag("--grid", arguments->grid,
                 wrapped("Add the cost and the move of every cell to the JSON"));
  arguments->limits.add_to(field);
  field.add_flag("--times", arguments->times, wrapped(kTimesHelp));
  add_format(field, arguments->format);
  arguments->output.add_to(
      field, {".csv", ".json"},
      "Also write x,y,cost,move of every cell (.csv) or the JSON; may be given "
      "several times",
      "the field (JSON with --format json, else CSV)");
  arguments->options.collect("field", option_schema<GridMoves>());
  arguments->options.add_to(field);
  field.footer(kFieldExamples);
  return {field, [field, arguments] {
            if (arguments->format != Format::json && !arguments->output.any(".json")) {
              refuse_idle(field, {"--grid"}, "it needs --format json or -o FILE.json");
            }
            if (arguments->format == Format::json || arguments->output.print()) {
              refuse_idle(field, {"--times"}, "it is for text; JSON always has them");
            }
            return run(*arguments);
          }};
}

}  // namespace wend::cli
