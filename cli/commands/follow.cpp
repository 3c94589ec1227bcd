// wend follow: a simulated robot follows a path.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/arguments/input_files.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/follow_run.hpp"
#include "cli/output/gnuplot.hpp"
#include "wend/base/parse.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {
namespace {

constexpr double kMargin = 0.1;  // m
constexpr NumberRange kMargins{0, 1e6, kMapUnit};
constexpr NumberRange kDriveSpeeds{1e-3, 1e6, "times the robot's speed"};

constexpr const char* kFollowExamples = R"(Examples:
  wend follow office.yaml --start 1,1 --goal 15,9 --smooth -o drive.png
  wend follow office.yaml --start 1,1 --goal 15,9 --controller pid --noise 0.02
  wend follow office.yaml --start 1,1 --goal 15,9 --compare --plot drive.svg
  wend follow office.yaml --path smooth.csv --compare=p_moving,pure_pursuit
  wend follow office.yaml --path smooth.csv --controller trajectory
  wend follow track.yaml --path centerline.csv --loop --speed 3 -o lap.gif

The path is planned with the robot's radius plus the margin, then simplified,
smoothed and resampled as the options say; the simulation uses the true radius.
Units are metres, radians and seconds; on maps without a resolution
--robot-radius and similar options are in cells, and a cell is a metre. The
planned path is red, the smoothed path green, the trajectory blue. Exit codes: 0
at least one controller reached the goal, 1 none did (standard error gives the
reason), 2 bad usage or input.)";

/// Options of planners whose flags are others here: of a smoother too, and of the noise.
bool has_another_flag(const OptionInfo& option) {
  return option.name == "turning_radius" || option.name == "seed";
}

void check(const FollowArguments& arguments) {
  arguments.output.check();
  check_read_once({arguments.map.file, arguments.path});
  const bool asked = !arguments.ends.start.empty() || !arguments.ends.goals.empty();
  if (asked && !arguments.path.empty()) {
    throw InputError("--path gives the path: leave out --start and --goal");
  }
  if (arguments.path.empty() && (arguments.ends.start.empty() || arguments.ends.goals.empty())) {
    throw InputError("give --start X,Y and --goal X,Y to plan a path, or a path file with --path");
  }
  if (arguments.loop && arguments.path.empty()) {
    throw InputError("--loop needs --path");
  }
  if (arguments.drive.compares() && arguments.output.any(".gif")) {
    throw InputError("-o FILE.gif supports one controller only: leave out --compare");
  }
  if (arguments.loop && arguments.trajectory.wanted()) {
    throw InputError("--loop does not support --trajectory: a trajectory ends where it stops");
  }
  if (arguments.plot.empty()) return;
  plot_kind_of(arguments.plot);
  check_folder(arguments.plot, "--plot " + arguments.plot);
  require_gnuplot();
}

/// Throws InputError for flags that were given and change nothing.
void check_idle(const Parser& follow, const FollowArguments& arguments) {
  const OutputFiles& output = arguments.output;
  arguments.pictures.check(follow, output.any_picture() || !arguments.plot.empty(),
                           arguments.format != Format::json);
  if (arguments.format != Format::json) {
    refuse_idle(follow, {"--samples"}, "add --format json; -o FILE.json always has the samples");
  }
  arguments.trajectory.check(follow, output);
  arguments.request.check(follow);
  if (!output.any(".gif")) refuse_idle(follow, {"--film-speed"}, "it needs -o FILE.gif");
  if (arguments.drive.compares()) {
    refuse_idle(follow, {"--controller"}, "--compare names the controllers");
  }
  if (arguments.drive.robot().drivetrain != Drivetrain::bicycle) {
    refuse_idle(follow, {"--wheelbase", "--steering-limit"}, "add --drivetrain bicycle");
  }
  const std::vector<std::string> noises{"--noise", "--actuation-noise", "--position-noise",
                                        "--heading-noise"};
  if (std::ranges::none_of(noises, [&](const auto& noise) { return follow.given(noise); })) {
    refuse_idle(follow, {"--seed"}, "it is the seed of the noise; add --noise S");
  }
  if (arguments.path.empty()) return;
  refuse_idle(follow,
              {"--nearest", "--nearest-limit", "--closest", "--limit-expansions", "--limit-time",
               "--clearance-distance", "--clearance-cost"},
              "with --path no path is planned");
  if (!arguments.refine.any()) {
    refuse_idle(follow, {"--margin", "--planner"}, "the path of --path is followed unchanged");
  }
  if (!planner_of(arguments).options.empty()) {
    throw InputError("options of planners change nothing: with --path no path is planned");
  }
}

/// For a robot that is larger by the margin: its shape for planners that choose headings, and for others the disc
/// around it.
FreeSpaceOptions planning_robot(const FollowArguments& arguments, const GridMap& map) {
  MapArguments larger = arguments.map;
  const double per_unit = larger.coordinates(map).in_metres(1);
  const double margin = arguments.margin.value_or(kMargin / per_unit);
  const bool headings = info_of(planner_of(arguments)).capabilities.headings;
  const Footprint shape = larger.as_typed().footprint;
  larger.footprint = headings && arguments.path.empty()
                         ? shape.grown(margin)
                         : Footprint::disc(shape.circumscribed_radius() + margin);
  return larger.options(map);
}

int run(const FollowArguments& arguments) {
  check(arguments);
  const LoadedMap loaded = arguments.map.load_map();
  arguments.output.check_not_among(loaded.files);
  arguments.trajectory.check_not_among(loaded.files);
  check_not_among(loaded.files, arguments.plot, "--plot " + arguments.plot);
  if (!arguments.path.empty()) {
    arguments.output.check_not_among({arguments.path});
    arguments.trajectory.check_not_among({arguments.path});
  }
  const auto session = arguments.map.session(loaded.map, 1, 0);
  const FreeSpace space = value_or_throw(session->view()).space;
  session->set_robot(planning_robot(arguments, loaded.map));
  FollowRun run(arguments, space, *session);
  if (!run.find_path()) return no_plan;
  run.drive();
  return run.report();
}

void add_path(Parser& app, FollowArguments& arguments) {
  app.add_option("--start", arguments.ends.start,
                 wrapped("Start of the planned path, as in `wend plan`"))
      .type_name("X,Y[,HEADING]");
  add_texts(app, "--goal", arguments.ends.goals,
            "Goal; if given several times, the goal with the lowest path cost")
      .type_name("X,Y[,HEADING]");
  arguments.request.add_others_to(app, {"escape"});
  app.add_option("--planner", arguments.planner,
                 wrapped("Planner (default astar); options may follow, as in astar:weight=2"))
      .type_name(kPlannerType);
  add_number(app, "--margin", arguments.margin, kMargins,
             "Margin that is added to the robot's radius for planning, to allow for tracking "
             "errors (units as --robot-radius; default 0.1 m)");
  app.add_option(
         "--path", arguments.path,
         wrapped("Follow this path instead: a file of `wend plan -o` or `wend smooth -o` (.csv, "
                 ".json; the smoothed path if there is one), or a centreline in metres"))
      .type_name(kFileType);
  app.add_flag("--loop", arguments.loop,
               wrapped("Drive one lap of the path of --path, back to its start"));
  arguments.refine.add_to(app);
  arguments.limits.add_to(app);
}

}  // namespace

Command add_follow(Parser& app) {
  Parser follow = app.add_subcommand("follow", "Simulate a robot that follows a path");
  const auto arguments = std::make_shared<FollowArguments>();
  arguments->map.add_to(follow);
  arguments->map.add_clearance_cost_to(follow);
  add_path(follow, *arguments);
  add_format(follow, arguments->format);
  follow.add_flag("--samples", arguments->samples,
                  wrapped("With --format json: add the robot's pose at every command"));
  arguments->pictures.add_to(follow);
  add_number(follow, "--film-speed", arguments->speed, kDriveSpeeds,
             "Playback speed of a .gif relative to real time (default: chosen so that it takes up "
             "to 8 s)");
  follow
      .add_option("--plot", arguments->plot,
                  wrapped("Plot speed, heading error and cross-track error over time (.png, .svg, "
                          ".pdf); needs gnuplot"))
      .type_name(kFileType);
  arguments->output.add_to(
      follow, {".png", ".svg", ".pdf", ".gif", ".json", ".csv"},
      "Also write a picture of the paths (.png, .svg, .pdf), an animation of the trajectory "
      "(.gif), or the robot's pose at every command (.json, .csv); may be given several times",
      "the trajectory (JSON with --format json, else CSV)");
  arguments->trajectory.add_file_to(follow);
  arguments->drive.add_to(follow);
  for (const PlannerInfo& planner : planners()) {
    std::vector<OptionInfo> options = planner.options;
    std::erase_if(options, has_another_flag);
    arguments->options.collect(planner.name, options);
  }
  arguments->options.add_to(follow, "--planner");
  follow.further({"--loop", "--samples", "--film-speed", "--limit-time", "--nearest",
                  "--turning-radius", "--trajectory", "--clearance-distance"});
  follow.footer(kFollowExamples);
  return {follow, [follow, arguments] {
            check_idle(follow, *arguments);
            return run(*arguments);
          }};
}

}  // namespace wend::cli
