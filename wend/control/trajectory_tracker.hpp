#pragma once

// TrajectoryTracker: a controller that tracks a trajectory: it drives the robot to where the trajectory
// is at the time, at the trajectory's speed.
//
//   wend::TrajectoryTracker tracker(*trajectory);
//   const wend::Drive tracked = wend::simulate(space, path, tracker);
//
// The follower's route has to be that of the trajectory's path, and the trajectory's limits no higher than
// the robot's: a slower robot falls behind and leaves the path. The time begins with the first command, or,
// if the robot faces another way than the trajectory's start, once it has turned in place. So a tracker is
// for one execution; track() begins another one. A robot that cannot turn in place needs a trajectory whose
// smallest_turning_radius() is at least that of the robot.
//
// With the reference's velocity (v, w), and its pose in the robot's frame (x, y, turned by t), it wants
//   v cos(t) + along_gain x   and   w + heading_gain t + side_gain v y.
// Y. Kanayama, Y. Kimura, F. Miyazaki and T. Noguchi, "A Stable Tracking Control Method for an
// Autonomous Mobile Robot", 1990.

#include "wend/base/compiler.hpp"
#include "wend/control/controller.hpp"
#include "wend/path/trajectory.hpp"

namespace wend {

/// How strongly the tracker corrects its errors.
struct TrackingGains {
  double along_gain = 2;    // 1/s: speed per metre that the robot is behind
  double heading_gain = 3;  // 1/s: turn rate per radian of heading error
  double side_gain = 10;    // 1/m^2: curvature per metre beside the trajectory

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"heading_gain", "turn rate per radian of heading error, 1/s"}, self.heading_gain,
          {0, 1e3});
    field({"along_gain", "speed per metre that the robot is behind, 1/s"}, self.along_gain,
          {0, 1e3});
    field({"side_gain", "curvature per metre beside the path, 1/m^2"}, self.side_gain, {0, 1e3});
  }
};

class WEND_API TrajectoryTracker final : public Controller {
 public:
  /// A tracker for one execution of the trajectory.
  explicit TrajectoryTracker(Trajectory trajectory, const TrackingGains& gains = {});

  /// Tracks another trajectory, from its start.
  void track(Trajectory trajectory);

  void begin(const MapPolyline& /*line*/, const VelocityLimits& /*limits*/) override {}

  /// Allocates no memory. O(log pieces).
  Velocity command(const ControllerInput& input) override;

  /// The time on the trajectory of the next command, s.
  double time() const { return time_; }

 private:
  bool begins(double turn);

  Trajectory trajectory_;
  TrackingGains gains_;
  double time_ = 0;
  bool begun_ = false;
};

}  // namespace wend
