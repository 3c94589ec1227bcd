#include "wend/control/controller.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/angle.hpp"

namespace wend {

#define WEND_CONTROLLER(name) ControllerInfo name##_controller();
#include "wend/control/controllers.def"

const Registry<ControllerInfo>& controllers() {
  static const Registry<ControllerInfo> registry({
#define WEND_CONTROLLER(name) name##_controller(),
#include "wend/control/controllers.def"
#include "wend/geometry/trigonometry.hpp"
  });
  return registry;
}

ControllerResult make_controller(std::string_view name, const OptionValues& options) {
  const auto info = controllers().named("controller", name);
  if (!info) return Unexpected<Error>(info.error());
  return (*info)->make(options);
}

std::optional<std::string> why_unfit(const ControllerInfo& info, const MotionModel& model) {
  if (!info.turns_in_place || model.turning_radius() == 0) return std::nullopt;
  return "the controller '" + info.name + "' turns in place, and a bicycle cannot";
}

double turn_to(const MapPose& pose, MapPoint point) {
  if (point == pose.point()) return 0;
  return normalized_angle(arc_tangent(point.y - pose.y, point.x - pose.x) - pose.heading);
}

double way_left(const MapPolyline& route, double along, MapPoint point) {
  return std::max(route.length() - along, distance(route.points().back(), point));
}

TrackingError tracking_error_of(const ControllerInput& input) {
  const MapPolyline& route = *input.route;
  return {turn_to(input.pose, route.points()[input.waypoint]),
          way_left(route, input.along, input.pose.point())};
}

Velocity while_turning(double linear, double angular, const TrackingError& error,
                       double standing_angle, const VelocityLimits& limits) {
  const double share = std::max(1 - std::abs(error.heading) / standing_angle, 0.0);
  return {std::clamp(linear, 0.0, limits.speed) * share, angular};
}

}  // namespace wend
