#pragma once

// Velocity: what a controller asks for and a robot does. Of all controllers and robots: metres,
// radians, seconds, in the map's frame.

namespace wend {

struct Velocity {
  double linear = 0;   // m/s along the heading, negative in reverse
  double angular = 0;  // rad/s, positive where the heading grows

  friend bool operator==(const Velocity&, const Velocity&) = default;
};

/// What a robot can do, and so what is asked of it at most.
struct VelocityLimits {
  double speed = 0.5;            // m/s
  double turn_rate = 1.5;        // rad/s
  double acceleration = 1;       // m/s^2, braking too
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

/// The nearest to `wanted` that the limits allow `seconds` after `now`; if `now` is beyond them, as
/// near to them as the accelerations allow.
Velocity limited(const Velocity& wanted, const Velocity& now, const VelocityLimits& limits,
                 double seconds);

}  // namespace wend
