#include "cli/commands/follow_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/plot/drive_plot.hpp"
#include "cli/arguments/input_files.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/output/explanations.hpp"
#include "cli/output/gnuplot.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/query_scene.hpp"
#include "cli/output/terminal.hpp"
#include "cli/watching/films.hpp"
#include "wend/base/parse.hpp"
#include "wend/control/simulation.hpp"
#include "wend/control/trajectory_tracker.hpp"
#include "wend/io/path/path_csv.hpp"
#include "wend/path/smoothing/corner_rounding.hpp"
#include "wend/planner/planner.hpp"
#include "wend/session/eased_query.hpp"

namespace wend::cli {
namespace {

bool reached(const ControlledDrive& driven) {
  return driven.drive.outcome == DriveOutcome::reached;
}

std::string oscillation(const ControlledDrive& driven) {
  return fmt::format(
      "{}: the controller oscillates ({} reversals in {:.2f} s): its gains are too high for this "
      "command rate, latency or noise",
      driven.controller, driven.drive.swings, driven.drive.time);
}

/// "reached the goal in 32.1 s, cross-track 0.021 m rms"
std::string caption_of(const Drive& drive) {
  return fmt::format("{} in {:.1f} s\ncross-track {:.3f} m rms, {:.3f} m at most",
                     describe(drive.outcome), drive.time, drive.cross_track_rms,
                     drive.cross_track_largest);
}

constexpr const char* kSteeredRadius = "turning_radius";

/// A controller needs a little of what the wheels can steer for itself: in whole centimetres.
double planned_radius(double turning_radius) {
  constexpr double kMore = 1.1;
  return std::ceil(turning_radius * kMore * 100) / 100;
}

}  // namespace

PlannerSpec planner_of(const FollowArguments& arguments) {
  PlannerSpec planner = parse_planner(arguments.planner);
  const OptionValues flags = arguments.options.values_for(planner.name);
  planner.options.insert(planner.options.end(), flags.begin(), flags.end());
  return planner;
}

FollowRun::FollowRun(const FollowArguments& arguments, FreeSpace space, FreeSpace planning_space)
    : arguments_(arguments),
      space_(std::move(space)),
      planning_space_(std::move(planning_space)),
      coordinates_(arguments.map.coordinates(space_.map())),
      robot_(arguments.drive.robot()),
      planner_(steered()),
      refinement_(arguments.refine.refinement(coordinates_)),
      simulation_(arguments.drive.simulation(arguments.loop)),
      following_(arguments.drive.following()) {
  arguments.drive.check_controllers(robot_);  // wrong ones are refused before the search
}

/// With the turning radius that was asked for, else one that the robot can steer.
PlannerSpec FollowRun::steered() const {
  PlannerSpec planner = planner_of(arguments_);
  arguments_.refine.steer(planner, coordinates_);
  const bool given = std::ranges::any_of(
      planner.options, [](const auto& option) { return option.first == kSteeredRadius; });
  const bool steers = robot_.turning_radius() > 0 && arguments_.path.empty();
  if (given || !steers || !has_option(info_of(planner).options, kSteeredRadius)) return planner;
  const double radius = planned_radius(robot_.turning_radius());
  planner.options.emplace_back(kSteeredRadius, format_number(radius));
  complain(
      fmt::format("the planner's turning radius is {:.3g} m, as the bicycle needs {:.3g} m; "
                  "--turning-radius sets "
                  "another one",
                  radius, robot_.turning_radius()));
  return planner;
}

bool FollowRun::find_path() {
  std::optional<Path> path = arguments_.path.empty() ? plan() : loaded();
  if (!path) return false;
  check_drivable(*path);
  const double rounding = arguments_.refine.rounding(coordinates_);
  path_ = refine(*path, planning_space_, refinement_, rounding);
  if (!lead_.empty()) path_ = with_lead(lead_, std::move(path_), planning_space_, rounding);
  controllers_ = arguments_.drive.controllers(robot_, path_.refined.path);
  return true;
}

/// Throws InputError for what simulate() would refuse, in the map's units and with what to do.
void FollowRun::check_drivable(const Path& path) const {
  const auto aside = first_step_aside(path);
  if (aside && robot_.drivetrain != Drivetrain::omni) {
    throw InputError(fmt::format(
        "the path steps to a side of the robot at {}, which only a robot of --drivetrain omni can "
        "do: plan with motions that only lead ahead, back or around",
        coordinates_.text(aside->point())));
  }
  if (robot_.turning_radius() == 0) return;
  if (const auto turn = first_turn_in_place(path)) {
    throw InputError(
        fmt::format("the path turns in place at {}, which a bicycle cannot do: plan it with "
                    "--planner hybrid_astar --motion-model reeds_shepp",
                    coordinates_.text(turn->point())));
  }
  const double radius = robot_.turning_radius() / space_.map().frame().resolution;
  if (const auto bend = first_bend_tighter_than(radius, path)) {
    throw InputError(fmt::format(
        "the path bends at {} tighter than the bicycle can steer: plan it with "
        "--turning-radius {} or more, or change --wheelbase and --steering-limit",
        coordinates_.text(bend->point()),
        format_number(planned_radius(robot_.turning_radius()) / coordinates_.in_metres(1))));
  }
}

/// If the path's file says that there is no path, the written files say so too.
Path FollowRun::loaded() const {
  try {
    return load_path_on(space_, coordinates_, arguments_.path, PathStage::smoothed);
  } catch (const NoPathError& error) {
    write_failure(error.plan(), Scene{.space = space_});
    throw;
  }
}

std::optional<Path> FollowRun::plan() {
  PlanRequest request = typed_request(planner_, planning_space_, coordinates_, arguments_.ends);
  arguments_.leeway.allow(request, coordinates_);
  request.escape = simulation_.escape;
  auto planner = info_of(planner_).make(planning_space_, planner_.options);
  if (!planner) throw InputError(planner.error().message);
  const GridMoves moves = (*planner)->grid_moves().value_or(GridMoves{});
  refinement_.adjacency = moves.adjacency();
  Explainer explainer = explainer_for(planning_space_, coordinates_, moves);
  explainer.allow(request.leeway());
  EasedQuery eased(query_of(request, planning_space_.map().frame()), **planner, explainer,
                   coordinates_, request.leeway());
  const Query asked = eased.query();
  ProgressBar progress("planning", (*planner)->state_count());
  const Query& query = eased.query();
  eased.query().limits = arguments_.limits.limits(progress);
  Plan plan;
  Status status = (*planner)->plan(query, plan);
  if (eased.ease_goals(status)) status = (*planner)->plan(query, plan);
  if (status == Status::found) eased.finish(plan);
  for (const std::string& note : eased.notes()) complain(note);
  if (status == Status::found) {
    lead_ = eased.lead();
    return std::move(plan.path);
  }
  const std::string margin =
      coordinates_.length(planning_space_.radius_in_cells() - space_.radius_in_cells());
  const FailedPlan failed{std::string(to_string(status)),
                          fmt::format("{} (these radii include the planning margin of {})",
                                      explainer.explain(**planner, query, eased.ends(request.texts),
                                                        status, plan.metrics),
                                      margin)};
  complain(failed.reason);
  write_failure(failed,
                failure_scene(planner_, planning_space_, asked, status, moves, coordinates_));
  return std::nullopt;
}

/// Replaces output files of earlier commands with the reason for the failure.
void FollowRun::write_failure(const FailedPlan& plan, const Scene& scene) const {
  arguments_.trajectory.write_failure(plan);
  auto writers =
      picture_writers({{"no path: " + plan.status, scene, plan.reason}}, arguments_.pictures.style);
  writers[".json"] = [&](const std::string& file) {
    return write_bytes(file, failed_plan_json(plan));
  };
  writers[".csv"] = [&](const std::string& file) { return write_bytes(file, no_path_csv(plan)); };
  writers[".gif"] = [&](const std::string& file) {
    return write_picture(
        file, gif_of("no path: " + plan.status, scene, style_of(arguments_.pictures.style)));
  };
  arguments_.output.write(writers, arguments_.format == Format::json ? ".json" : ".csv");
}

/// The robot's own shape has to fit along the rounded corners: the margin is for errors.
SampledTrajectory FollowRun::timed_path() const {
  return arguments_.trajectory.along(path_.refined.path, space_,
                                     arguments_.refine.rounding(coordinates_),
                                     refinement_.adjacency, arguments_.drive.trajectory_limits());
}

/// Tracks the trajectory along the path with rounded corners.
Drive FollowRun::tracked(const TrackingGains& gains) const {
  if (simulation_.closed) {
    throw InputError("--loop does not support the controller trajectory: use pure_pursuit");
  }
  constexpr double kAside = 1e-6;
  for (const Segment& way : path_.refined.path.segments()) {
    if (std::abs(way.course) <= kAside || robot_.drivetrain != Drivetrain::omni) continue;
    throw InputError("the controller trajectory does not support moves to a side: use stanley");
  }
  const Trajectory trajectory = timed_path().trajectory;
  constexpr double kRounding = 1e-6;
  if (trajectory.smallest_turning_radius() < robot_.turning_radius() * (1 - kRounding)) {
    throw InputError(fmt::format(
        "the trajectory has a turning radius of {:.3g} m, and the bicycle needs {:.3g} m: smooth "
        "the path with --smoother curvature --turning-radius R",
        trajectory.smallest_turning_radius(), robot_.turning_radius()));
  }
  const Path rounded = value_or_throw(rounded_corners(
      path_.refined.path, space_, arguments_.refine.rounding(coordinates_), refinement_.adjacency));
  TrajectoryTracker tracker(trajectory, gains);
  return simulate(space_, rounded, tracker, robot_, simulation_, following_);
}

void FollowRun::drive() {
  for (ChosenController& chosen : controllers_) {
    Drive driven = chosen.controller ? simulate(space_, path_.refined.path, *chosen.controller,
                                                robot_, simulation_, following_)
                                     : tracked(chosen.gains);
    if (driven.outcome == DriveOutcome::refused) throw InputError(driven.refusal);
    drives_.push_back({chosen.text, std::move(driven)});
  }
}

Scene FollowRun::scene_of_path() const {
  std::vector<SceneLine> lines = lines_of(path_);
  if (!arguments_.refine.any()) lines.pop_back();
  for (SceneLine& line : lines) {
    if (arguments_.loop) line.points.push_back(line.points.front());
  }
  return scene_of(space_, std::move(lines));
}

Scene FollowRun::scene_of_drive(const ControlledDrive& driven) const {
  Scene scene = scene_of_path();
  SceneLine line{LineRole::driven, {}};
  for (const DriveSample& sample : driven.drive.samples) line.points.push_back(sample.pose.point());
  scene.lines.push_back(std::move(line));
  scene.collision = driven.drive.first_collision;
  return scene;
}

/// One drive is a picture of its own.
std::vector<Panel> FollowRun::panels() const {
  std::vector<Panel> panels;
  for (const ControlledDrive& driven : drives_) {
    const bool alone = drives_.size() == 1;
    panels.push_back({alone ? "" : driven.controller, scene_of_drive(driven),
                      alone ? "" : caption_of(driven.drive)});
  }
  return panels;
}

std::string FollowRun::text() const {
  const std::string path =
      arguments_.refine.any()
          ? refined_text(path_, coordinates_)
          : metrics_table(std::vector{path_.measured_before}, coordinates_.unit());
  const Screen screen = detect_screen();
  std::string text = path + "\n" + drive_table(drives_, table_width(screen));
  if (drives_.size() > 1) return text;
  return picture_above(text, scene_of_drive(drives_.front()), screen, arguments_.pictures);
}

void FollowRun::write_files() const {
  if (arguments_.trajectory.wanted()) arguments_.trajectory.write(timed_path());
  const Frame& frame = space_.map().frame();
  const StyleName style = arguments_.pictures.style;
  auto writers = picture_writers(panels(), style);
  writers[".json"] = [&](const std::string& file) {
    return write_bytes(file, drive_json(path_, drives_, frame, DriveSamples::all));
  };
  writers[".csv"] = [&](const std::string& file) {
    return write_bytes(file, drive_csv(drives_, frame));
  };
  writers[".gif"] = [&](const std::string& file) {
    return write_picture(
        file, gif_of_drive(drives_.front().controller, scene_of_path(), drives_.front().drive,
                           arguments_.speed, style_of(style)));
  };
  arguments_.output.write(writers, arguments_.format == Format::json ? ".json" : ".csv");
  if (arguments_.plot.empty()) return;
  const std::string script =
      drive_plot(drives_, plot_kind_of(arguments_.plot), plot_colours_of(style));
  const std::string wrong = write_bytes(arguments_.plot, drawn_by_gnuplot(script));
  if (!wrong.empty()) throw InputError(wrong);
}

ExitCode FollowRun::report() const {
  const DriveSamples samples = arguments_.samples ? DriveSamples::all : DriveSamples::none;
  if (!arguments_.output.print()) {
    print(arguments_.format == Format::json
              ? drive_json(path_, drives_, space_.map().frame(), samples)
              : text());
  }
  write_files();
  for (const ControlledDrive& driven : drives_) {
    if (driven.drive.oscillates()) complain(oscillation(driven));
    if (reached(driven)) continue;
    const Point end = driven.drive.samples.back().pose.point();
    complain(fmt::format("{}: it {} after {:.2f} s, at {}", driven.controller,
                         describe(driven.drive.outcome), driven.drive.time,
                         coordinates_.text(end)));
  }
  return std::ranges::any_of(drives_, reached) ? success : no_plan;
}

}  // namespace wend::cli
