// wend explore: a robot drives over a map that it does not know.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/input_files.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/output/explanations.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/terminal.hpp"
#include "cli/watching/exploration_film.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/explore/explorer.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/report/exploration_report.hpp"
#include "wend/session/failure_text.hpp"

namespace wend::cli {
namespace {

constexpr NumberRange kRanges{1e-6, 1e9, kMapUnit};
constexpr NumberRange kShares{0, 100};

struct ExploreArguments {
  MapArguments map;
  std::string start;
  std::string goal;
  std::string known;
  std::optional<double> sensor_range;
  std::string planners = "replanner";
  ReplanWhen when = ReplanWhen::path;
  double keep = 0;
  LimitArguments limits;
  TableFormat format = TableFormat::text;
  PictureArguments pictures;
  OutputFiles output;
};

constexpr const char* kExploreExamples = R"(Examples:
  wend explore office.yaml --start 1,1 --goal 15,9 --sensor-range 5
  wend explore office.yaml --start 1,1 --goal 15,9 -o drive.gif
  wend explore office.yaml --start 1,1 --goal 15,9 \
    --planner replanner,d_star_lite,astar
  wend explore now.yaml --known before.yaml --start 1,1 --goal 15,9

MAP is the true map. The robot does not know it, or knows an older map
(--known). It treats cells that it has not seen as free. Before each step it
sees what its laser scanner reaches, and plans again if it has to. The table
says what it drove and how long each planner took, in CPU time; the picture
shows the drive of the first planner on the map as it knows it in the end, a
.gif all of it. Exit codes: 0 the robot arrived, 1 it did not (standard error
gives the reason), 2 bad usage or input.)";

/// The drives that were asked for, one after the other.
class ExploreRun {
 public:
  explicit ExploreRun(const ExploreArguments& arguments, const LoadedMap& loaded)
      : arguments_(arguments),
        map_(loaded.map),
        coordinates_(arguments.map.coordinates(loaded.map)),
        start_(coordinates_.parse("start", arguments.start)),
        goal_(coordinates_.parse("goal", arguments.goal)) {
    constexpr double kMetres = 5;
    constexpr double kCells = 30;
    const double range = arguments.sensor_range.value_or(coordinates_.metric() ? kMetres : kCells);
    report_.start = start_.cell;
    report_.goal = goal_.cell;
    report_.sensor_range = coordinates_.metric() ? range / map_.frame().resolution : range;
    if (!arguments.known.empty()) {
      auto known = load_map(arguments.known);
      if (!known) throw InputError(known.error().message);
      complain_of_notes(arguments.known, *known);
      known_ = std::move(known->map);
    }
  }

  void drive(const PlannerSpec& planner, const std::string& name);
  int report() const;

 private:
  ExplorerOptions options_for(const PlannerSpec& planner, ProgressBar& progress) const;
  void write_files() const;
  std::string text() const;

  const ExploreArguments& arguments_;
  GridMap map_;
  Coordinates coordinates_;
  Place start_;
  Place goal_;
  std::optional<GridMap> known_;
  ExplorationReport report_;
  std::unique_ptr<Scene> scene_;  // the end of the first drive
  ExplorationFilm film_;          // of the first drive
};

ExplorerOptions ExploreRun::options_for(const PlannerSpec& planner, ProgressBar& progress) const {
  ExplorerOptions options;
  options.robot = arguments_.map.options(map_);
  options.known = known_;
  options.sensor_range = report_.sensor_range;
  options.planner = planner;
  options.when = arguments_.when;
  options.keep = arguments_.keep;
  options.limits = arguments_.limits.limits(progress);
  options.clock = thread_cpu_seconds;
  return options;
}

void ExploreRun::drive(const PlannerSpec& planner, const std::string& name) {
  ProgressBar progress("exploring", 0);
  auto explorer = Explorer::make(map_, start_.cell, goal_.cell, options_for(planner, progress));
  if (!explorer) {
    const Error& error = explorer.error();
    if (error.status == Status::invalid_option) throw InputError(error.message);
    throw NoPathError(error.message, {});
  }
  const bool first = scene_ == nullptr;
  const bool filmed = first && arguments_.output.any(".gif");
  std::optional<Status> end;
  while (!end && !Interruptible::cancelled()) {
    end = explorer->step();
    if (filmed) film_.take(*explorer);
  }
  if (first) scene_ = std::make_unique<Scene>(scene_now(*explorer));
  report_.rows.push_back({name, end.value_or(Status::cancelled),
                          words_of(explorer->failure(), explorer->believed(), command_line_hints()),
                          explorer->driven(), explorer->driven_cost(), explorer->totals()});
}

std::string ExploreRun::text() const {
  const Screen screen = detect_screen();
  const std::string table =
      exploration_table(report_, map_.frame(), coordinates_.metric(), table_width(screen));
  return picture_above(table, *scene_, screen, arguments_.pictures);
}

void ExploreRun::write_files() const {
  std::map<std::string, FileWriter> writers =
      picture_writers({{report_.rows.front().planner, *scene_, {}}}, arguments_.pictures.style);
  writers[".gif"] = [&](const std::string& file) {
    return write_picture(file, film_.gif(report_.rows.front().planner, *scene_,
                                         style_of(arguments_.pictures.style)));
  };
  writers[".json"] = [&](const std::string& file) {
    return write_bytes(file, exploration_json(report_, map_.frame()));
  };
  writers[".csv"] = [&](const std::string& file) {
    return write_bytes(file, exploration_csv(report_, map_.frame()));
  };
  arguments_.output.write(writers);
}

int ExploreRun::report() const {
  switch (arguments_.format) {
    case TableFormat::text:
      print(text());
      break;
    case TableFormat::json:
      print(exploration_json(report_, map_.frame()));
      break;
    case TableFormat::csv:
      print(exploration_csv(report_, map_.frame()));
      break;
  }
  write_files();
  bool arrived = false;
  for (const ExplorationRow& row : report_.rows) {
    arrived = arrived || row.status == Status::found;
    if (row.status != Status::found) complain(row.planner + ": " + row.reason);
  }
  return arrived ? success : no_plan;
}

int run(const ExploreArguments& arguments) {
  arguments.output.check();
  check_read_once({arguments.map.file, arguments.known});
  const std::vector<PlannerSpec> planners = parse_planners(arguments.planners);
  const LoadedMap loaded = arguments.map.load_map();
  arguments.output.check_not_among(loaded.files);
  if (!arguments.known.empty()) arguments.output.check_not_among({arguments.known});
  arguments.map.free_space(loaded.map, info_of(planners.front()).bytes_per_cell);  // its checks
  const Interruptible interruptible;
  ExploreRun run(arguments, loaded);
  for (const PlannerSpec& planner : planners) run.drive(planner, planner.text);
  return run.report();
}

}  // namespace

Command add_explore(Parser& app) {
  Parser explore = app.add_subcommand("explore", "Drive over a map that the robot does not know");
  const auto arguments = std::make_shared<ExploreArguments>();
  arguments->map.add_to(explore);
  arguments->map.add_clearance_cost_to(explore);
  explore.add_option("--start", arguments->start, wrapped("Start, as in `wend plan`"))
      .required()
      .type_name("X,Y");
  explore.add_option("--goal", arguments->goal, wrapped("Goal, as in `wend plan`"))
      .required()
      .type_name("X,Y");
  explore
      .add_option("--known", arguments->known,
                  wrapped("Map file of what the robot believes at first, of the same size "
                          "(default: it knows nothing)"))
      .type_name(kFileType);
  add_number(explore, "--sensor-range", arguments->sensor_range, kRanges,
             "Range of the laser scanner (default 5 m, or 30 cells on maps without a resolution)");
  explore
      .add_option("--planner", arguments->planners,
                  wrapped("Planners, separated by commas, each with options after a colon; one "
                          "drive for each (default replanner)"))
      .type_name(kPlannerType);
  add_choice(
      explore, "--replan", arguments->when, named_values<ReplanWhen>(),
      "When to plan again: path: if the path ahead is blocked or costs more; discovery: after "
      "every discovery that is not as believed (default path)");
  add_number(explore, "--keep", arguments->keep, kShares,
             "Share by which another path must be cheaper than what is left of the last one, if "
             "that is still free, to be taken when the robot plans again (default 0)");
  arguments->limits.add_to(explore);
  add_table_format(explore, arguments->format);
  arguments->pictures.add_to(explore);
  arguments->output.add_to(
      explore, {".gif", ".png", ".svg", ".pdf", ".json", ".csv"},
      "Also write a film of the first drive (.gif), a picture of it (.png, .svg, "
      ".pdf), or the table (.csv, .json); may be given several times");
  explore.further({"--keep"});
  explore.footer(kExploreExamples);
  return {explore, [explore, arguments] {
            arguments->pictures.check(explore, arguments->output.any_picture(),
                                      arguments->format == TableFormat::text);
            return run(*arguments);
          }};
}

}  // namespace wend::cli
