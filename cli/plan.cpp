// wend plan: a path from a start to a goal.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "command.hpp"
#include "exit_code.hpp"
#include "explain.hpp"
#include "flags.hpp"
#include "limit_arguments.hpp"
#include "map_arguments.hpp"
#include "nearest_ends.hpp"
#include "option_flags.hpp"
#include "output.hpp"
#include "output_files.hpp"
#include "picture.hpp"
#include "plan_text.hpp"
#include "planner_argument.hpp"
#include "visited_cells.hpp"
#include "wend/io/path_csv.hpp"
#include "wend/io/write_file.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/drawing.hpp"
#include "wend/report/plan_json.hpp"

namespace wend::cli {
namespace {

struct PlanArguments {
  MapArguments map;
  std::string start;
  std::string goal;
  std::string planner = "astar";
  OptionFlags options{"planner"};
  LimitArguments limits;
  bool nearest = false;
  Format format = Format::text;
  PictureWhen picture = PictureWhen::automatic;
  OutputFiles output;
};

constexpr const char* kExamples = R"(Examples:
  wend plan office.yaml --start 1,1 --goal 15,9 --robot-radius 0.2 -o plan.png
  wend plan arena.map --start 1,11 --goal 40,30 --planner astar --weight 2
  wend plan grid.txt --start 0,0 --goal 9,9 --connectivity 4 --format json
  wend plan office.yaml --cells --start 10,10 --goal 145,85 --nearest

Small maps (up to 80 x 40 cells) show the path as (1,1)>(2,1)>(3,1) and the map with
arrows; large ones a summary and, on a terminal, a picture. Exit codes: 0 found, 1 no plan
(standard error says why), 2 bad usage or input.)";

/// One query, from its arguments to its outcome.
class PlanRun {
 public:
  PlanRun(const PlanArguments& arguments, PlannerSpec planner, FreeSpace space)
      : arguments_(arguments),
        planner_(std::move(planner)),
        space_(std::move(space)),
        coordinates_(arguments.map.coordinates(space_.map())),
        adjacency_(moves_of(planner_).adjacency()),
        ends_{coordinates_.parse("start", arguments.start),
              coordinates_.parse("goal", arguments.goal)},
        visited_(space_.width(), space_.height()) {}

  /// Plans. Throws InputError for options out of range.
  void plan();

  /// Prints and writes what came out.
  ExitCode report() const;

 private:
  void search(Planner& planner);
  void fail(Status status, std::string reason);
  Scene scene() const;
  std::string text(const Screen& screen) const;
  void write_files() const;

  const PlanArguments& arguments_;
  PlannerSpec planner_;
  FreeSpace space_;
  Coordinates coordinates_;
  Adjacency adjacency_;
  Ends ends_;
  VisitedCells visited_;
  PlanResult result_;
};

void PlanRun::plan() {
  result_.planner = planner_.name;
  if (arguments_.nearest) {
    for (const auto& note : move_to_nearest(ends_, space_, coordinates_, adjacency_)) {
      complain(note);
    }
  }
  const auto planner = info_of(planner_).make(space_, planner_.options);
  if (planner) {
    search(**planner);
  } else if (planner.error().status == Status::invalid_option) {
    throw InputError(planner.error().message());
  } else {
    fail(planner.error().status, planner.error().message());
  }
}

void PlanRun::search(Planner& planner) {
  ProgressBar progress("planning", space_.passable().count());
  Query query = Query::between(ends_.start.cell, ends_.goal.cell);
  query.limits = arguments_.limits.limits(progress);
  // Only small maps show visited cells; elsewhere nobody is to slow the search down.
  if (is_small(space_.map(), Screen{})) query.observer = &visited_;
  const double begin = steady_seconds();
  result_.status = planner.plan(query, result_.plan);
  result_.seconds = steady_seconds() - begin;
  if (result_.status == Status::found) return;
  const Explainer explainer(space_, coordinates_, adjacency_);
  fail(result_.status,
       explainer.explain(result_.status, ends_, query.limits, result_.plan.metrics));
}

void PlanRun::fail(Status status, std::string reason) {
  result_.status = status;
  result_.reason = std::move(reason);
}

/// A random walk crosses itself, which arrows cannot show, and a search that was stopped has no
/// path: the cells that they visited are shown instead.
Scene PlanRun::scene() const {
  Scene scene{.space = space_};
  scene.start = centre_of(ends_.start.cell);
  scene.goals = {centre_of(ends_.goal.cell)};
  const bool walked = planner_.name == "random_walk" && !visited_.empty();
  if (walked || result_.plan.path.empty()) {
    scene.marked = {{CellRole::expanded, visited_.cells()}};
  } else {
    scene.path = result_.plan.path;
  }
  return scene;
}

std::string PlanRun::text(const Screen& screen) const {
  std::string text;
  const bool found = result_.status == Status::found;
  const bool small = is_small(space_.map(), screen);
  if (found && small) text += path_line(result_.plan.path);
  // Of a failure there is something to see where a search has begun.
  if (found || (small && result_.plan.metrics.expanded > 0)) {
    text += picture(scene(), screen, arguments_.picture);
  }
  if (found) text += plan_summary(result_, space_.map().frame());
  return text;
}

void PlanRun::write_files() const {
  const Frame& frame = space_.map().frame();
  const auto message = [](const auto& written) {
    return written ? std::string() : written.error().message();
  };
  const auto save_picture = [&](const std::string& file, const auto& picture) {
    return picture ? message(write_file(file, *picture)) : file + ": " + picture.error().message();
  };
  std::map<std::string, FileWriter> writers{
      {".png", [&](const std::string& file) { return save_picture(file, draw_png(scene())); }},
      {".svg", [&](const std::string& file) { return save_picture(file, draw_svg(scene())); }},
      {".json", [&](const std::string& file) {
         return message(write_file(file, plan_json(result_, frame)));
       }}};
  if (result_.status == Status::found) {
    writers[".csv"] = [&](const std::string& file) {
      return message(save_path_csv(result_.plan.path, frame, file));
    };
  }
  arguments_.output.write(writers);
}

ExitCode PlanRun::report() const {
  if (arguments_.format == Format::json) {
    print(plan_json(result_, space_.map().frame()));
  } else {
    print(text(detect_screen()));
  }
  write_files();
  if (result_.status == Status::found) return success;
  complain(result_.reason);
  return no_plan;
}

int run(const PlanArguments& arguments) {
  arguments.output.check();
  PlannerSpec planner = parse_planner(arguments.planner);
  const OptionValues flags = arguments.options.values_for(planner.name);
  planner.options.insert(planner.options.end(), flags.begin(), flags.end());
  const LoadedMap loaded = arguments.map.load();
  arguments.output.check_not_among(loaded.files);
  PlanRun run(arguments, std::move(planner), arguments.map.free_space(loaded.map));
  run.plan();
  return run.report();
}

}  // namespace

Command add_plan(CLI::App& app) {
  CLI::App& plan = *app.add_subcommand("plan", "Plan a path from a start to a goal");
  const auto arguments = std::make_shared<PlanArguments>();
  arguments->map.add_to(plan);
  plan.add_option("--start", arguments->start,
                  wrapped("Where the path begins: metres in the map's frame for a map with a "
                          "resolution, a cell for others and with --cells"))
      ->required()
      ->type_name("X,Y");
  plan.add_option("--goal", arguments->goal, "Where it ends")->required()->type_name("X,Y");
  plan.add_flag("--nearest", arguments->nearest,
                wrapped("Where start or goal is blocked, plan from or to the nearest free cell "
                        "that is connected to the other end"));
  plan.add_option(
          "--planner", arguments->planner,
          wrapped("The planner (default astar): `wend planners` lists them; options may follow as "
                  "in astar:weight=2"))
      ->type_name(kPlannerType);
  arguments->limits.add_to(plan);
  add_format(plan, arguments->format);
  add_picture(plan, arguments->picture);
  arguments->output.add_to(plan, {".png", ".svg", ".csv", ".json"},
                           "Also write a picture (.png, .svg), the path (.csv; nothing if there is "
                           "none) or the JSON; may be given several times");
  for (const PlannerInfo& planner : planners()) {
    arguments->options.collect(planner.name, planner.options);
  }
  arguments->options.add_to(plan);
  plan.footer(kExamples);
  return {&plan, [arguments] { return run(*arguments); }};
}

}  // namespace wend::cli
