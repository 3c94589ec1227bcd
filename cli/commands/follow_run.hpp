#pragma once

// One run of `wend follow`: plans or reads a path, drives along it, reports.

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/drive_arguments.hpp"
#include "cli/arguments/flags.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/option_flags.hpp"
#include "cli/arguments/refine_arguments.hpp"
#include "cli/arguments/request_arguments.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/arguments/trajectory_arguments.hpp"
#include "cli/arguments/typed_request.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/picture/panels.hpp"
#include "wend/report/drive_report.hpp"
#include "wend/session/session.hpp"

namespace wend::cli {

struct FollowArguments {
  MapArguments map;
  EndArguments ends;  // empty where a path is read
  std::string planner = "astar";
  OptionFlags options{"planner"};
  RequestArguments request;  // without --escape, which is an option of the simulation
  std::string path;
  bool loop = false;
  std::optional<double> margin;  // in the user's units
  RefineArguments refine;
  DriveArguments drive;
  TrajectoryArguments trajectory;
  LimitArguments limits;
  Format format = Format::text;
  bool samples = false;
  PictureArguments pictures;
  std::optional<double> speed;
  std::string plot;
  OutputFiles output;
};

/// The planner and its options, flags included. Throws InputError for options that it does not have.
PlannerSpec planner_of(const FollowArguments& arguments);

class FollowRun {
 public:
  /// The free space of the robot, and a session that plans with a margin around it, which outlives this. Throws
  /// InputError for options out of range.
  FollowRun(const FollowArguments& arguments, FreeSpace space, Session& session);

  /// Finds the path. If there is no path, says so and returns false.
  bool find_path();

  void drive();

  /// Prints and writes the results.
  ExitCode report() const;

 private:
  PlannerSpec steered() const;
  std::uint64_t states() const;
  std::optional<Path> plan();
  void check_drivable(const Path& path) const;
  SampledTrajectory timed_path() const;
  Drive tracked(const TrackingGains& gains) const;
  Path loaded() const;
  void write_failure(const FailedPlan& plan, const Scene& scene) const;
  Scene scene_of_drive(const ControlledDrive& driven) const;
  Scene scene_of_path() const;
  std::vector<Panel> panels() const;
  std::string text() const;
  void write_files() const;

  const FollowArguments& arguments_;
  FreeSpace space_;
  Session& session_;
  FreeSpace planning_space_;  // of the session
  Coordinates coordinates_;
  MotionModel robot_;
  PlannerSpec planner_;
  Refinement refinement_;
  SimulationOptions simulation_;
  FollowerOptions following_;
  std::vector<ChosenController> controllers_;
  Path lead_;  // the way out that the path begins with, if it does
  RefinedPath path_;
  std::vector<ControlledDrive> drives_;
};

}  // namespace wend::cli
