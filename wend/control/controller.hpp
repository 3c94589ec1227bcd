#pragma once

// Controllers: what tells a robot how fast to drive and to turn, so that it follows a path. By name
// and with options; `wend/control/controllers.def` lists them, one file each.
//
//   const wend::ControllerInfo* info = wend::controllers().find("pure_pursuit");
//   const auto controller = info->make({{"lookahead", "0.5"}});
//   if (!controller) report(controller.error().message());
//
// Metres, radians, seconds, in the map's frame. A controller remembers (integrals, filters), is for
// one robot and one thread. It may allocate memory in begin(), for a line longer
// than all before, and does not in command().

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/base/registry.hpp"
#include "wend/control/motion_model.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// What a controller sees; all numbers are finite. To drive in reverse it is shown the robot as if
/// it faced backwards, so that it need not know.
struct ControllerInput {
  Pose pose;          // as measured
  Velocity velocity;  // as last commanded and limited
  const Polyline* route =
      nullptr;               // what to follow, in metres: the line that has begun; never null
  double along = 0;          // how far along it the robot is; never goes back
  std::size_t waypoint = 0;  // of route->points(): the next one to reach
  double seconds = 0;        // since the last command, > 0
  VelocityLimits limits{};
};

class Controller {
 public:
  virtual ~Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  /// A new line begins: it forgets what it remembers, and prepares itself. The line outlives the
  /// commands that follow.
  virtual void begin(const Polyline& line, const VelocityLimits& limits) = 0;

  /// What it wants, on the line that has begun; whoever drives limits it.
  virtual Velocity command(const ControllerInput& input) = 0;

 protected:
  Controller() = default;
};

using ControllerResult = Expected<std::unique_ptr<Controller>, OptionError>;

struct ControllerInfo {
  std::string name;
  std::string summary;   // one line
  std::string idea;      // how it works, in two or three sentences
  std::string citation;  // the paper or textbook it comes from
  bool turns_in_place;   // so it is no controller for a bicycle
  std::vector<OptionInfo> options;
  std::function<ControllerResult(const OptionValues&)> make;
};

/// p, p_moving, pid, pure_pursuit.
const Registry<ControllerInfo>& controllers();

/// What ControllerInfo::make does: makes a controller from its options as text.
template <class Made, class Options>
ControllerResult make_controller(const OptionValues& values) {
  const auto options = parse_options<Options>(values);
  if (!options) return Unexpected<OptionError>(options.error());
  return std::make_unique<Made>(*options);
}

/// Why a controller is none for a robot: it turns in place, and the robot cannot. Nothing if it is;
/// whoever puts the two together asks.
std::optional<std::string> why_unfit(const ControllerInfo& info, const MotionModel& model);

/// How far the robot must turn to face a point, in (-pi, pi]; 0 where it stands on it.
double turn_to(const Pose& pose, Point point);

/// What is left of a route: along it and, where that has come to its end, straight to the end.
double way_left(const Polyline& route, double along, Point point);

/// The errors that P and PID controllers feed back.
struct TrackingError {
  double heading = 0;   // rad, to face the next waypoint
  double distance = 0;  // m, what is left
};

TrackingError tracking_error_of(const ControllerInput& input);

/// Drives so fast, but slower the larger the heading error is, and not at all from `standing_angle`
/// on; and turns so fast.
Velocity while_turning(double linear, double angular, const TrackingError& aim,
                       double standing_angle, const VelocityLimits& limits);

}  // namespace wend
