// wend explain: why there is no path, and what would make one.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/option_flags.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/explain_drive.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/explanations.hpp"
#include "cli/output/no_path_scene.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/terminal.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/base/parse.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/report/analysis_report.hpp"

namespace wend::cli {
namespace {

struct ExplainArguments {
  MapArguments map;
  std::string start;
  std::string goal;
  std::string planner;
  OptionFlags options{"move"};
  OptionFlags drive_options{"planner"};
  std::optional<double> turning_radius;
  Format format = Format::text;
  PictureArguments pictures;
  OutputFiles output;
};

constexpr const char* kExplainExamples = R"(Examples:
  wend explain office.yaml --start 1,1 --goal 15,9 --robot-radius 0.6
  wend explain office.yaml --start 1,1 --goal 15,9 --robot-radius 0.6 -o why.png
  wend explain grid.txt --start 0,0 --goal 9,9 --format json
  wend explain office.yaml --planner hybrid_astar --start 2,2,E --goal 14,8,any

The picture shows the cells that can be reached from the start, the cells from
which the goal can be reached, and the nearest free cell to a blocked end. The
dashed line is the path that the smallest change would open, with its narrowest
place. With --planner hybrid_astar it says what the robot's footprint, turning
radius and gears have to do with it, and the dashed line is the widest path of a
disc. Exit codes: 0 there is a path, 1 there is no path, 2 bad usage or input.)";

/// One question, from its arguments to its answer.
class ExplainRun {
 public:
  ExplainRun(const ExplainArguments& arguments, GridMoves moves, FreeSpace space)
      : arguments_(arguments),
        moves_(moves),
        space_(std::move(space)),
        coordinates_(arguments.map.coordinates(space_.map())),
        explainer_(explainer_for(space_, coordinates_, moves_)),
        start_(coordinates_.parse("start", arguments.start)),
        goal_(coordinates_.parse("goal", arguments.goal)) {
    for (const Place& place : {start_, goal_}) {
      if (!space_.contains(place.cell)) throw InputError(explainer_.outside(place));
    }
    why_ = explain_no_path(space_, start_.cell, goal_.cell, moves_);
  }

  ExitCode report() const;

 private:
  std::string text() const;
  std::string headline() const;
  std::string component(const Place& place, std::size_t cells) const;
  std::string causes() const;
  std::string on_obstacles() const;
  std::string parted() const;
  Scene scene() const;

  const ExplainArguments& arguments_;
  GridMoves moves_;
  FreeSpace space_;
  Coordinates coordinates_;
  Explainer explainer_;
  Place start_;
  Place goal_;
  NoPath why_;
};

std::string ExplainRun::headline() const {
  const std::string text =
      why_.path_exists()
          ? fmt::format("there is a path from {} to {}", start_.text, goal_.text)
          : fmt::format("there is no path from start {} to goal {}", start_.text, goal_.text);
  return folded(text, detect_screen().columns) + "\n";
}

std::string ExplainRun::component(const Place& place, std::size_t cells) const {
  const std::string blocked = explainer_.blocked(place);
  return blocked.empty() ? coordinates_.area(cells) : blocked;
}

/// For every possible cause, whether it prevents a path.
std::string ExplainRun::causes() const {
  const auto says = [this](bool Way::* change, std::string_view what, std::string_view otherwise) {
    const auto has = [change](const Way& way) { return way.*change; };
    const auto way = std::find_if(why_.ways.begin(), why_.ways.end(), has);
    if (way == why_.ways.end()) return explanation_line(what, "not the cause");
    if (way->changes() > 1) return explanation_line(what, "a part of the cause");
    return explanation_line(what, fmt::format("the cause: {}", otherwise));
  };
  return says(&Way::smaller_robot, "robot's size", "there is a path for a smaller robot") +
         says(&Way::unknown_free, "unknown cells", "there is a path through them") +
         says(&Way::squeeze, "corner rule",
              "there is a path between obstacles that touch at a corner") +
         explanation_line(
             "connectivity",
             "not the cause: without corner cutting, 4 and 8 neighbours reach the same cells");
}

/// The ends that lie on an obstacle: "start and goal"; empty where none does.
std::string ExplainRun::on_obstacles() const {
  std::string names;
  for (const Place& place : {start_, goal_}) {
    if (space_.why_blocked(place.cell) != BlockReason::obstacle) continue;
    names += (names.empty() ? "" : " and ") + place.name;
  }
  return names;
}

/// Why no robot of any size gets from one to the other.
std::string ExplainRun::parted() const {
  const std::string names = on_obstacles();
  return names.empty() ? "obstacles separate the two" : "an obstacle lies on " + names;
}

std::string ExplainRun::text() const {
  std::string text = headline();
  text += picture(scene(), detect_screen(), arguments_.pictures);
  text += explanation_line("start's component", component(start_, why_.start_component)) +
          explanation_line("goal's component", component(goal_, why_.goal_component));
  text += explanation_line("widest path", why_.widest ? "robot " + explainer_.width(*why_.widest)
                                                      : "none, even with radius 0: " + parted());
  if (why_.path_exists()) return text;
  text += causes();
  for (const Way& way : why_.ways) {
    text += explanation_line(way.widest.path.empty() ? "" : "would help", explainer_.change(way));
  }
  if (why_.ways.empty()) {
    text += explanation_line("would help", on_obstacles().empty() ? "nothing but another map"
                                                                  : "another " + on_obstacles());
  }
  return text;
}

Scene ExplainRun::scene() const {
  return no_path_scene(space_, start_.cell, goal_.cell, moves_, coordinates_, why_);
}

ExitCode ExplainRun::report() const {
  if (arguments_.format == Format::json) {
    print(no_path_json(why_, space_.map().frame()));
  } else {
    print(text());
  }
  auto writers = picture_writers({{{}, scene(), {}}}, arguments_.pictures.style);
  writers[".json"] = [this](const std::string& file) {
    return write_bytes(file, no_path_json(why_, space_.map().frame()));
  };
  arguments_.output.write(writers);
  return why_.path_exists() ? success : no_plan;
}

constexpr std::string_view kTurningRadius = "turning_radius";

std::vector<OptionInfo> drive_options() {
  std::vector<OptionInfo> options = option_schema<HybridAStarOptions>();
  std::erase_if(options, [](const OptionInfo& option) { return option.name == kTurningRadius; });
  return options;
}

/// Throws InputError for flags that change nothing.
void check_idle(const Parser& explain, const ExplainArguments& arguments) {
  if (!arguments.planner.empty()) {
    return refuse_idle(explain, {"--connectivity", "--corner-rule"},
                       "a planner over poses has no moves between cells");
  }
  std::vector<std::string> flags{"--turning-radius"};
  for (const OptionInfo& option : drive_options()) {
    std::string flag = "--" + option.name;
    std::replace(flag.begin(), flag.end(), '_', '-');
    flags.push_back(flag);
  }
  refuse_idle(explain, flags, "it needs --planner hybrid_astar");
}

/// The planner with all its options. Throws InputError for another planner.
PlannerSpec drive_planner(const ExplainArguments& arguments, const Coordinates& coordinates) {
  PlannerSpec planner = parse_planner(arguments.planner);
  if (planner.name != HybridAStarOptions::kPlanner) {
    throw InputError(
        fmt::format("--planner {}: explain takes hybrid_astar; without --planner it explains all "
                    "planners that step from cell to cell",
                    planner.name));
  }
  const OptionValues flags = arguments.drive_options.values_for(planner.name);
  planner.options.insert(planner.options.end(), flags.begin(), flags.end());
  if (arguments.turning_radius) {
    planner.options.emplace_back(kTurningRadius,
                                 format_number(coordinates.in_metres(*arguments.turning_radius)));
  }
  return planner;
}

int run(const ExplainArguments& arguments) {
  arguments.output.check();
  const auto moves = parse_options<GridMoves>(arguments.options.values_for("explain"));
  if (!moves) throw InputError(moves.error().message);
  const LoadedMap loaded = arguments.map.load_map();
  arguments.output.check_not_among(loaded.files);
  if (arguments.planner.empty()) {
    return ExplainRun(arguments, *moves, arguments.map.free_space(loaded.map)).report();
  }
  const Coordinates coordinates = arguments.map.coordinates(loaded.map);
  PlannerSpec planner = drive_planner(arguments, coordinates);
  return explain_drive({std::move(planner), arguments.start, arguments.goal, arguments.format,
                        arguments.pictures, arguments.output},
                       arguments.map.free_space(loaded.map), coordinates);
}

}  // namespace

Command add_explain(Parser& app) {
  Parser explain = app.add_subcommand("explain", "Explain why there is no path, and what helps");
  const auto arguments = std::make_shared<ExplainArguments>();
  arguments->map.add_to(explain);
  explain.add_option("--start", arguments->start, wrapped("Start, as in `wend plan`"))
      .required()
      .type_name("X,Y[,HEADING]");
  explain.add_option("--goal", arguments->goal, "Goal, as in `wend plan`")
      .required()
      .type_name("X,Y[,HEADING]");
  explain
      .add_option("--planner", arguments->planner,
                  wrapped("hybrid_astar: explain why it finds no drive. Default: explain planners "
                          "that step from cell to cell"))
      .type_name(kPlannerType);
  add_number(explain, "--turning-radius", arguments->turning_radius, {0, 1e6},
             "Least turning radius for --planner hybrid_astar (units as --robot-radius)");
  add_format(explain, arguments->format);
  arguments->pictures.add_to(explain);
  arguments->output.add_to(explain, {".png", ".svg", ".pdf", ".json"},
                           "Also write a picture (.png, .svg, .pdf) or the JSON; may be given "
                           "several times");
  arguments->options.collect("explain", option_schema<GridMoves>());
  arguments->options.add_to(explain);
  arguments->drive_options.collect(std::string(HybridAStarOptions::kPlanner), drive_options());
  arguments->drive_options.add_to(explain, "--planner");
  explain.footer(kExplainExamples);
  return {explain, [explain, arguments] {
            arguments->pictures.check(explain, arguments->output.any_picture(),
                                      arguments->format != Format::json);
            check_idle(explain, *arguments);
            return run(*arguments);
          }};
}

}  // namespace wend::cli
