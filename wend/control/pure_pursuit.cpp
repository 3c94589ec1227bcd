// Pure pursuit: R. Coulter, "Implementation of the Pure Pursuit Path Tracking Algorithm", 1992;
// regulated as by S. Macenski, S. Singh, F. Martín and J. Ginés, "Regulated Pure Pursuit for Robot
// Path Tracking", 2023.

#include <algorithm>
#include <cmath>

#include "wend/control/controller.hpp"
#include "wend/control/route.hpp"
#include "wend/control/speed_profile.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

struct PurePursuitOptions {
  double lookahead = 0.2;
  double lookahead_time = 0.3;
  double slow_radius = 0.6;
  double lateral_acceleration = 1;
  double approach = 0.5;
  double min_speed = 0.05;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"lookahead", "lookahead distance at standstill, m"}, self.lookahead, {1e-2, 1e3});
    field({"lookahead_time", "lookahead time at the current speed, s, added to the distance"},
          self.lookahead_time, {0, 1e2});
    field({"slow_radius", "radius below which the robot slows down in curves, m"}, self.slow_radius,
          {0, 1e3});
    field({"lateral_acceleration", "upper limit on the lateral acceleration in curves, m/s^2"},
          self.lateral_acceleration, {1e-3, 1e3});
    field({"approach", "distance to the goal at which the robot starts to slow down, m"},
          self.approach, {0, 1e3});
    field({.name = "min_speed", .help = "lower limit on the speed, m/s", .former = "least_speed"},
          self.min_speed, {1e-4, 1e3});
  }
};

/// Of a line that ends with an arc, given by chords: from the headings of its last two pieces of length `window`. 0 if
/// its last line does not lead as that arc ends: then it ends behind a corner.
double curvature_at_end(const MapPolyline& line, double window) {
  constexpr double kChord = 0.1;  // rad: a chord leads as its middle does
  const double piece = std::min(window, line.length() / 2);
  if (piece <= Route::kSamePlace) return 0;
  const double middle = line.heading_at(line.length() - piece / 2, piece / 2);
  const double before = line.heading_at(line.length() - 3 * piece / 2, piece / 2);
  const double turn = normalized_angle(middle - before);
  const double last = line.at(line.length()).heading;
  const bool is_arc = std::abs(normalized_angle(middle + turn / 2 - last)) <= kChord;
  return is_arc ? turn / piece : 0;
}

class PurePursuitController final : public Controller {
 public:
  explicit PurePursuitController(const PurePursuitOptions& options) : options_(options) {}

  void begin(const MapPolyline& line, const VelocityLimits& limits) override {
    end_curvature_ = curvature_at_end(line, options_.lookahead);
    profile_.begin(line, {.limits = limits,
                          .lateral_acceleration = options_.lateral_acceleration,
                          .min_speed = options_.min_speed,
                          .window = options_.lookahead,
                          .lookahead = options_.lookahead,
                          .lookahead_time = options_.lookahead_time});
  }

  Velocity command(const ControllerInput& input) override {
    constexpr double kTurnGain = 2;  // 1/s
    if (input.turn != 0) return {0, kTurnGain * input.turn};
    const MapPose& pose = input.pose;
    const MapPoint target = target_of(input);
    const double turn = turn_to(pose, target);
    if (std::abs(turn) > kPi / 2) {  // behind: round in the tightest circle
      return {options_.min_speed, std::copysign(input.limits.turn_rate, turn)};
    }
    // The circle through the target that is tangent to the heading.
    const double chord = distance(pose.point(), target);
    constexpr double kOnTarget = 1e-6;  // m: nearer, its direction is rounding
    const double curvature = chord > kOnTarget ? 2 * sine_and_cosine(turn).sine / chord : 0;
    const double speed = speed_on(curvature, input);
    return {speed, speed * curvature};
  }

 private:
  /// On the route, the lookahead farther along than the robot; beyond its end where its last line or arc goes on, so
  /// that the robot comes in as the route ends. Once it has passed the end, the end.
  MapPoint target_of(const ControllerInput& input) const {
    const MapPolyline& route = *input.route;
    // Before the end, farther still: there the heading counts more than the last millimetres beside the line.
    const double left = route.length() - input.along;
    const double farther = options_.lookahead +
                           options_.lookahead_time * std::abs(input.velocity.linear) +
                           std::max(2 * options_.lookahead - left, 0.0);
    const double along = input.along + farther;
    const MapPose place = route.at(along);
    const double beyond = along - route.length();
    if (beyond <= 0 || input.along >= route.length()) return place.point();
    // No farther round than a quarter: else the target would come back.
    const double bend = std::abs(end_curvature_);
    const double way = bend > 0 ? std::min(beyond, kPi / 2 / bend) : beyond;
    return point_on(MapArc{place, way, end_curvature_}, way);
  }

  double speed_on(double curvature, const ControllerInput& input) const {
    const VelocityLimits& limits = input.limits;
    const double bend = std::abs(curvature);
    const double left = way_left(*input.route, input.along, input.pose.point());
    double speed = profile_.at(input.along);
    if (bend * options_.slow_radius > 1) speed /= bend * options_.slow_radius;
    if (left < options_.approach) speed *= left / options_.approach;
    speed = std::max(speed, options_.min_speed);
    return bend * speed > limits.turn_rate ? limits.turn_rate / bend : speed;
  }

  PurePursuitOptions options_;
  SpeedProfile profile_;
  double end_curvature_ = 0;  // 1/m, of the line
};

}  // namespace

ControllerInfo pure_pursuit_controller() {
  return {.name = "pure_pursuit",
          .summary = "Pure pursuit: drives on a circle to a point ahead on the path",
          .idea =
              "The target is the point of the path at the lookahead distance; the robot drives on "
              "the circle through it. The lookahead distance grows with the speed. The robot "
              "brakes in time for curves and for the goal.",
          .citation = "Coulter 1992; regulated: Macenski, Singh, Martín, Ginés 2023",
          .turns_in_place = false,
          .options = option_schema<PurePursuitOptions>(),
          .make = controller_from<PurePursuitController, PurePursuitOptions>};
}

}  // namespace wend
