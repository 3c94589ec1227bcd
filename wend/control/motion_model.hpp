#pragma once

// Motion models: the motion of a robot at a commanded velocity, integrated exactly: at constant
// velocities a robot drives an arc. Metres, radians, seconds, in the map's frame.
//
//   wend::RobotState robot{{0, 0, 0}};
//   const wend::Step step = wend::drive(wend::MotionModel{}, robot, {0.3, 0.1}, 0.05);
//   robot = step.to;

#include <array>

#include "wend/base/choice.hpp"
#include "wend/base/compiler.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/map_pose.hpp"

namespace wend {

/// A commanded or actual velocity.
struct Velocity {
  double linear = 0;   // m/s along the heading, negative in reverse
  double angular = 0;  // rad/s, positive where the heading grows
  double lateral = 0;  // m/s to the left; 0 but for a robot that moves to its sides

  friend bool operator==(const Velocity&, const Velocity&) = default;
};

/// The limits of a robot's velocity and acceleration.
struct VelocityLimits {
  double speed = 0.5;            // m/s
  double turn_rate = 1.5;        // rad/s
  double acceleration = 1;       // m/s^2, also for braking
  double turn_acceleration = 5;  // rad/s^2

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"speed", "upper limit on the speed, m/s"}, self.speed, {1e-3, 1e3});
    field({"turn_rate", "upper limit on the turn rate, rad/s"}, self.turn_rate, {1e-3, 1e3});
    field({"acceleration", "upper limit on acceleration and braking, m/s^2"}, self.acceleration,
          {1e-3, 1e6});
    field({"turn_acceleration", "upper limit on the angular acceleration, rad/s^2"},
          self.turn_acceleration, {1e-3, 1e6});
  }
};

/// The velocity nearest to `wanted` that the limits allow `seconds` after `now`. If `now` exceeds
/// the limits, the one nearest to them that the accelerations allow. With a lateral part, the limits of
/// speed and acceleration are those of the whole motion.
WEND_API Velocity limited(const Velocity& wanted, const Velocity& now, const VelocityLimits& limits,
                          double seconds);

/// How a robot turns.
enum class Drivetrain {
  differential,  // turns in place
  bicycle,       // steers: turns only while it drives, by tan(steering) / wheelbase a metre
  omni,          // moves in every direction, and turns while it does
};

constexpr std::array<Choice<Drivetrain>, 3> choice_names(Drivetrain) {
  return {{{"differential", Drivetrain::differential},
           {"bicycle", Drivetrain::bicycle},
           {"omni", Drivetrain::omni}}};
}

/// A kind of robot and its limits.
struct WEND_API MotionModel {
  Drivetrain drivetrain = Drivetrain::differential;  // how it turns
  double wheelbase = 0.3;                            // m, of a bicycle
  double steering_limit = 0.6;                       // rad, of a bicycle, below pi / 2
  VelocityLimits limits{};                           // of its velocity and acceleration

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"drivetrain",
           "how the robot moves: on two driven wheels (differential), by steering (bicycle), or to "
           "every side (omni)"},
          self.drivetrain);
    field({"wheelbase", "bicycle: distance between the axles, m"}, self.wheelbase, {1e-3, 1e3});
    field({"steering_limit", "bicycle: upper limit on the steering angle, rad"},
          self.steering_limit, {1e-3, 1.5});
    VelocityLimits::fields(self.limits, field);
  }

  /// The radius of the tightest circle that it can drive, in metres; 0 if it turns in place.
  double turning_radius() const;
};

/// Where a robot is, and how fast it moves.
struct RobotState {
  MapPose pose;         // where it is
  Velocity velocity{};  // m/s and rad/s
};

/// A short motion: an arc (of length 0 for a turn in place) and the state at its end.
struct Step {
  MapArc arc;     // the way of the robot; its heading is the direction of travel
  RobotState to;  // the state at its end
  double course =
      0;  // rad, how far to the left of the robot's heading the arc leads: of an omni robot
};

/// Holds a velocity. Below a nanometre a second the robot turns in place.
WEND_API Step hold(const MapPose& from, const Velocity& velocity, double seconds);

/// Drives for `seconds` within the limits: the velocity is first limited, then held; only an omni robot moves to
/// its sides. A bicycle's
/// turn rate is at most |linear| / turning_radius(); where that would change it too fast, it brakes
/// less.
WEND_API Step drive(const MotionModel& model, const RobotState& from, const Velocity& wanted,
                    double seconds);

}  // namespace wend
