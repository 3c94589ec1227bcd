// Stanley: G. Hoffmann, C. Tomlin, M. Montemerlo and S. Thrun, "Autonomous Automobile Trajectory
// Tracking for Off-Road Driving: Controller Design, Experimental Validation and Racing", 2007.
//
// The law steers a wheel that lies the wheelbase ahead of the base point: by the wheel's angle to the
// course, and by atan(gain e / speed) for its distance e beside it. So de/dt = -gain e near the course,
// and the base point is drawn after the wheel as a trailer is: both errors vanish. The course is not the
// path, which a wheel ahead of the base point leaves in every bend, but the way of that wheel while the
// base point is on the path. So there is no lasting error in a bend.
//
// In reverse it is the kinematic form of the same law: the wheel lies the wheelbase behind the base point,
// where the robot drives to. A robot whose base point does not slip to the side moves the same way turned
// round, so this is as stable as driving ahead. (A car that steers its front wheels in reverse is not: there
// the errors at the front wheels grow.) The follower shows the robot turned round, so this file knows
// nothing about gears.

#include <algorithm>
#include <cmath>

#include "wend/control/controller.hpp"
#include "wend/control/speed_profile.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

struct StanleyOptions {
  double cross_track_gain = 2;
  double front_distance = 0.2;
  double steering_window = 0.1;
  double lateral_acceleration = 1;
  double min_speed = 0.05;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"cross_track_gain", "rate at which the front wheel comes back to its course, 1/s"},
          self.cross_track_gain, {0, 1e3});
    field({"front_distance", "distance from the base point to the steered wheel of the law, m"},
          self.front_distance, {1e-2, 1e3});
    field({"steering_window",
           "length of path before and ahead of the robot over which its curvature is averaged, m"},
          self.steering_window, {1e-3, 1e3});
    field({"lateral_acceleration", "upper limit on the lateral acceleration in curves, m/s^2"},
          self.lateral_acceleration, {1e-3, 1e3});
    field({.name = "min_speed", .help = "lower limit on the speed, m/s", .former = "least_speed"},
          self.min_speed, {1e-4, 1e3});
  }
};

class StanleyController final : public Controller {
 public:
  explicit StanleyController(const StanleyOptions& options) : options_(options) {}

  void begin(const MapPolyline& line, const VelocityLimits& limits) override {
    profile_.begin(line, {.limits = limits,
                          .lateral_acceleration = options_.lateral_acceleration,
                          .min_speed = options_.min_speed,
                          .window = options_.steering_window,
                          .lookahead = options_.front_distance});
  }

  Velocity command(const ControllerInput& input) override {
    constexpr double kTurnGain = 2;  // 1/s
    if (input.turn != 0) return {0, kTurnGain * input.turn};
    const double speed = std::max(profile_.at(input.along), options_.min_speed);
    const double steering = steering_of(input, speed);
    const double curvature = tangent(steering) / options_.front_distance;
    const double most = input.limits.turn_rate / std::abs(curvature);
    const double slow = std::min(speed, std::max(most, options_.min_speed));
    return {slow, slow * curvature};
  }

 private:
  /// Where the base point should be, and how the path bends there.
  struct Place {
    MapPose pose;
    double curvature = 0;  // 1/m
  };

  Place place_at(const MapPolyline& line, double along) const {
    const double window = options_.steering_window;
    const double heading = line.heading_at(along, window);
    const double from = std::max(along - window, 0.0);
    const double to = std::min(along + window, line.length());
    const MapPose on_line = line.at(along);
    if (from >= to) return {on_line, 0};
    // Over the window even where the line is shorter: a short end is no tighter bend.
    const double turn = line.heading_at(to, window) - line.heading_at(from, window);
    return {{on_line.x, on_line.y, heading}, normalized_angle(turn) / std::max(to - from, window)};
  }

  double steering_of(const ControllerInput& input, double speed) const {
    constexpr double kMost = radians_from(80);
    const double reach = options_.front_distance;
    const Place place = place_at(*input.route, input.along);
    const MapPose& robot = input.pose;
    // The wheel of a robot on the path, its course, and the wheel of this robot in that frame.
    const double course = place.pose.heading + arc_tangent(reach * place.curvature, 1);
    const SineCosine ahead = sine_and_cosine(robot.heading);
    const SineCosine path = sine_and_cosine(place.pose.heading);
    const double dx = robot.x + reach * ahead.cosine - (place.pose.x + reach * path.cosine);
    const double dy = robot.y + reach * ahead.sine - (place.pose.y + reach * path.sine);
    const auto [sine, cosine] = sine_and_cosine(course);
    const double left = cosine * dy - sine * dx;
    const double back = arc_tangent(-options_.cross_track_gain * left / speed, 1);
    return std::clamp(normalized_angle(course - robot.heading + back), -kMost, kMost);
  }

  StanleyOptions options_;
  SpeedProfile profile_;
};

}  // namespace

ControllerInfo stanley_controller() {
  return {
      .name = "stanley",
      .summary = "Stanley: steers a wheel ahead of the base point to its course, also in reverse",
      .idea =
          "The robot steers a wheel that lies ahead of its base point: by the wheel's angle to "
          "its course, and by its distance beside it. The course is the way of that wheel along "
          "the path, so that the robot has no lasting error in bends. In reverse, the wheel lies "
          "behind the base point.",
      .citation = "Hoffmann, Tomlin, Montemerlo, Thrun 2007",
      .turns_in_place = false,
      .options = option_schema<StanleyOptions>(),
      .make = controller_from<StanleyController, StanleyOptions>};
}

}  // namespace wend
