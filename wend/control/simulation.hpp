#pragma once

// Simulation: a robot follows a path on a map, with noise and latency; the result has measures of
// it.
//
//   auto controller = wend::make_controller("pid");
//   const wend::Drive drive = wend::simulate(space, plan->path, **controller, {}, {.seed = 7});
//   if (drive.outcome != wend::DriveOutcome::reached) report(wend::describe(drive.outcome));
//
// Every command is held for 1 / rate seconds; the robot drives exact arcs, and its disc is swept along
// each of them over the map. Noise is Gaussian and comes from a seed: the same on every platform,
// except for the last bits of mathematical functions. Thread-safe with one controller per thread.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/choice.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/error.hpp"
#include "wend/control/follower.hpp"
#include "wend/control/motion_model.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The rate, the noise and the end of a simulation.
struct SimulationOptions {
  double rate = 20;               // commands a second
  double time_limit = 0;          // s; 0: 60 s and ten times what the path takes at full speed
  double actuation_noise = 0;     // standard deviation of each velocity's relative error
  double position_noise = 0;      // of each measured coordinate, m
  double heading_noise = 0;       // of the measured heading, rad
  double latency = 0;             // s from a measurement to the effect of its command
  std::int64_t seed = 1;          // of the noise, 0 to 9e15
  bool closed = false;            // one lap, back to the start
  bool stop_at_collision = true;  // else the robot drives on, and collisions are counted
  double escape = 0;  // m, within which a robot that does not fit at the start may leave it

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"rate", "command rate, commands per second"}, self.rate, {0.1, 1e4});
    field({"time_limit",
           "limit on the simulated time, s; 0: ten times the duration of the path plus 60"},
          self.time_limit, {0, 1e6});
    field({"actuation_noise", "relative error of the executed motion, standard deviation"},
          self.actuation_noise, {0, 10});
    field({"position_noise", "error of the measured position, m, standard deviation"},
          self.position_noise, {0, 1e3});
    field({"heading_noise", "error of the measured heading, rad, standard deviation"},
          self.heading_noise, {0, 10});
    field({"latency", "delay from a measurement to the effect of its command, s"}, self.latency,
          {0, 10});
    field({"seed", "seed of the noise"}, self.seed, {0, 9e15});
    field({"closed", "drive one lap of a closed path"}, self.closed);
    field({"stop_at_collision", "stop at the first collision"}, self.stop_at_collision);
    field(
        {"escape",
         "if the robot does not fit at the start: how far it may drive, m, before it fits, without "
         "a collision where it does not go deeper into what blocks it; 0: off"},
        self.escape, {0, 1e6});
  }
};

/// How a drive ended.
enum class DriveOutcome {
  reached,    // the robot stands within the tolerances of the goal
  stuck,      // FollowerState::stuck
  off_path,   // FollowerState::off_path
  collision,  // the robot collided, and stop_at_collision is set
  time,       // SimulationOptions::time_limit passed, or the deadline
  missed,     // it stands beside the goal, where its poses, with their noise, tell that it is there
  refused     // it did not begin: Drive::refusal says why
};

constexpr std::array<Choice<DriveOutcome>, 7> choice_names(DriveOutcome) {
  return {{{"reached", DriveOutcome::reached},
           {"stuck", DriveOutcome::stuck},
           {"off_path", DriveOutcome::off_path},
           {"collision", DriveOutcome::collision},
           {"time", DriveOutcome::time},
           {"missed", DriveOutcome::missed},
           {"refused", DriveOutcome::refused}}};
}

/// "reached the goal", "got stuck", "left the path", "ran into an obstacle", "ran out of time", "stopped beside
/// the goal", "was refused".
WEND_API std::string_view describe(DriveOutcome outcome);

/// The robot at one moment; grid coordinates, the rest metres, radians and seconds.
struct DriveSample {
  double time = 0;           // s since the start
  Pose pose;                 // true, not measured; grid coordinates
  Velocity velocity;         // true
  double heading_error = 0;  // of the route's mean heading (FollowerOptions::heading_window), rad
  double cross_track = 0;    // m, signed: positive left of the route (towards +y from +x)
};

/// A simulated drive: its outcome, its measures, and the poses.
struct WEND_API Drive {
  DriveOutcome outcome = DriveOutcome::reached;  // how it ended
  std::string refusal = {};                      // why it did not begin, for refused; else empty
  double time = 0;                               // s
  double distance = 0;                           // m
  double turned = 0;                             // rad, to the left and to the right together
  std::uint64_t swings = 0;        // from turning fast one way to turning fast the other way
  double cross_track_rms = 0;      // m
  double cross_track_largest = 0;  // m
  double final_error = 0;          // m, from the goal
  double final_heading_error = 0;  // rad; of a route's last heading, or its last line's
  std::uint64_t collisions = 0;    // how often the swept disc entered an obstacle from free space
  std::optional<Point> first_collision;  // the disc's centre at that moment, grid coordinates
  std::vector<DriveSample> samples;      // one a command, and the last pose

  /// Does the robot swing to and fro more than once a second? Then the controller's gains are too
  /// high for its rate, its latency or the noise. Fast means a fifth of the greatest turn rate.
  bool oscillates() const;
};

/// The controller that suits a path: stanley for a path of poses, whose arcs it does not cut; else pure_pursuit,
/// which rounds the corners of lines.
WEND_API std::string_view default_controller(const Path& path);

/// Why such a robot cannot drive along a path: it is empty, has numbers that are not finite or places that no
/// route can hold; it steps to a side; a bicycle would turn in place, or tighter than it can steer. Nothing if it
/// can. O(n).
WEND_API std::optional<Error> why_undrivable(const Path& path, const Frame& frame,
                                             const MotionModel& model);

/// Drives from the path's start, heading along it (for a car's path, as its first pose), until the robot stands,
/// whatever the outcome, or the time is over. The path is in grid coordinates of the space's map. What
/// why_undrivable() tells, and options out of their ranges, are refused: the drive has no samples. The controller
/// is reset first. With a controller that why_unfit() rejects, a bicycle gets stuck. O(commands), 1e6 at most;
/// every run ends: see Follower. The deadline ends it where the robot is.
WEND_API Drive simulate(const FreeSpace& space, const Path& path, Controller& controller,
                        const MotionModel& model = {}, const SimulationOptions& options = {},
                        const FollowerOptions& follower = {}, const Deadline& deadline = {});

}  // namespace wend
