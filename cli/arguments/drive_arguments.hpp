#pragma once

// The arguments of driving: controllers, the robot, disturbances, and when the robot has arrived.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/option_flags.hpp"
#include "wend/base/options.hpp"
#include "wend/control/controller.hpp"
#include "wend/control/simulation.hpp"
#include "wend/control/trajectory_tracker.hpp"
#include "wend/path/trajectory.hpp"

namespace wend::cli {

/// A controller that was asked for, as it was typed. Without a controller: the path's trajectory is
/// tracked with these gains.
struct ChosenController {
  std::string text;
  std::unique_ptr<Controller> controller;
  TrackingGains gains{};
};

/// What --controller takes: the names in the registry, and "trajectory".
std::vector<std::string> controller_names();

class DriveArguments {
 public:
  void add_to(Parser& app);

  /// Throw InputError for values out of range. `loop`: one lap.
  SimulationOptions simulation(bool loop) const;
  FollowerOptions following() const;
  MotionModel robot() const;

  /// The robot's limits, and --lateral-acceleration.
  TrajectoryLimits trajectory_limits() const;

  /// One or more controllers; the one that suits the path if none was asked for. Throws InputError for one that
  /// does not exist or that the robot cannot follow.
  std::vector<ChosenController> controllers(const MotionModel& robot, const Path& path) const;

  /// Throws InputError as controllers() does, before there is a path.
  void check_controllers(const MotionModel& robot) const;

  bool compares() const { return compared_.has_value(); }

 private:
  std::string controller_;               // empty: the default for the path
  std::optional<std::string> compared_;  // as typed; empty: all that fit the robot
  std::optional<double> noise_;
  OptionFlags controller_options_{"controller"};
  OptionFlags simulation_{"simulation"};
  OptionFlags following_{"follower"};
  OptionFlags robot_{"robot"};
};

}  // namespace wend::cli
