#pragma once

// Controllers: compute the velocities with which a robot follows a path. They have names and
// options; `wend/control/controllers.def` lists them, one file each.
//
//   const auto controller = wend::make_controller("pure_pursuit", {{"lookahead", "0.5"}});
//   if (!controller) report(controller.error().message);
//
// Metres, radians, seconds, in the map's frame. A controller has state (integrals, filters); use
// one per robot and thread. It may allocate memory in begin(), for a line longer than all before,
// but not in command().

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/base/registry.hpp"
#include "wend/control/motion_model.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// What a controller sees; all numbers are finite. On a reverse leg the robot's pose is turned
/// round, so a controller does not need to know about reversing.
struct ControllerInput {
  MapPose pose;                        // as measured
  Velocity velocity;                   // as last commanded and limited
  const MapPolyline* route = nullptr;  // the line to follow; never null
  double along = 0;                    // how far along it the robot is; never goes back
  std::size_t waypoint = 0;            // of route->points(): the next one to reach
  double seconds = 0;                  // since the last command, > 0
  VelocityLimits limits{};             // of the robot
  bool reverse = false;                // the leg is a reverse one: `pose` is turned round
  double turn = 0;                     // rad, still to turn in place before the line; else 0
};

/// Computes the velocity with which a robot follows a line.
class Controller {
 public:
  virtual ~Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  /// Begins a new line: resets the controller's state and prepares it. The line must outlive the
  /// commands that follow.
  virtual void begin(const MapPolyline& line, const VelocityLimits& limits) = 0;

  /// The wanted velocity on the current line. The caller applies the limits.
  virtual Velocity command(const ControllerInput& input) = 0;

 protected:
  Controller() = default;
};

/// A controller, or why it could not be made: invalid_option.
using ControllerResult = Expected<std::unique_ptr<Controller>, Error>;

/// A controller: its description, its options, and the function that makes it.
struct ControllerInfo {
  std::string name;                 // as in options
  std::string summary;              // one line
  std::string idea;                 // how it works, in two or three sentences
  std::string citation;             // the paper or book it comes from
  bool turns_in_place;              // so it does not fit a bicycle
  std::vector<OptionInfo> options;  // which `make` takes
  std::function<ControllerResult(const OptionValues&)> make;  // from options as text
};

/// p, p_moving, pid, pure_pursuit, stanley.
WEND_API const Registry<ControllerInfo>& controllers();

/// Makes a controller by name; an unknown name or option is Status::invalid_option.
WEND_API ControllerResult make_controller(std::string_view name, const OptionValues& options = {});

/// What ControllerInfo::make does: makes a controller from its options as text.
template <class Made, class Options>
ControllerResult controller_from(const OptionValues& values) {
  const auto options = parse_options<Options>(values);
  if (!options) return Unexpected<Error>(options.error());
  return std::make_unique<Made>(*options);
}

/// Why a controller does not fit a robot: it turns in place, and the robot cannot. Nothing if it
/// fits. The caller that combines the two must ask.
WEND_API std::optional<std::string> why_unfit(const ControllerInfo& info, const MotionModel& model);

/// The turn that makes the robot face a point, in (-pi, pi]; 0 if the robot is at the point.
WEND_API double turn_to(const MapPose& pose, MapPoint point);

/// The remaining length of a route; past its end, the straight distance to the end.
WEND_API double way_left(const MapPolyline& route, double along, MapPoint point);

/// The errors that P and PID controllers feed back.
struct TrackingError {
  double heading = 0;   // rad, to face the next waypoint
  double distance = 0;  // m, the remaining length
};

/// The errors against the next waypoint and the end of the line.
WEND_API TrackingError tracking_error_of(const ControllerInput& input);

/// Drives at `linear`, slower with a larger heading error, and stands still from `standing_angle`
/// on; turns at `angular`.
WEND_API Velocity while_turning(double linear, double angular, const TrackingError& error,
                                double standing_angle, const VelocityLimits& limits);

}  // namespace wend
