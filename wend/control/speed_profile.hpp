#pragma once

// SpeedProfile: the speed limit of a robot at each place of a line, so that it brakes in time.
//
//   const wend::SpeedProfile profile(line, {.lateral_acceleration = 1, .window = 0.2});
//   const double fastest = profile.at(along);
//
// Where the line bends with a curvature c, the speed v is at most
// - the turn rate / |c|,
// - the root of the lateral acceleration / |c|,
// - the root of the turn acceleration / |dc/ds|, for that is how fast a robot, a bicycle too, steers;
// already the lookahead before it, where a pursuit begins to turn. Then, from the end of the line, at
// which the robot stands, to its beginning: v^2 <= v_next^2 + 2 a ds, what it can brake. The curvature
// is the change of the mean heading (Polyline::heading_at), so that a corner is a bend as long as the
// window. Metres, radians, seconds. O(length / window) to make.
//
// It is for controllers, which find their own way back to the line. A Trajectory (trajectory.hpp) is exact
// and has time stamps; both use its limits in a bend and the passes of speed_passes.hpp.

#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/control/motion_model.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// The limits of a profile.
struct SpeedProfileOptions {
  VelocityLimits limits{};          // of the robot
  double lateral_acceleration = 1;  // m/s^2
  double min_speed = 0.05;          // m/s
  double window = 0.2;              // m, > 0: half of what headings are averaged over
  double lookahead = 0;             // m: the bend's speed limit begins this length before it,
  double lookahead_time = 0;        // s: plus the length driven in this time
};

class WEND_API SpeedProfile {
 public:
  /// A profile without a line.
  SpeedProfile() = default;

  /// The profile of a line: see begin().
  SpeedProfile(const MapPolyline& line, const SpeedProfileOptions& options) {
    begin(line, options);
  }

  /// Begins another line. Allocates memory only for a line longer than all before.
  void begin(const MapPolyline& line, const SpeedProfileOptions& options);

  /// The speed limit there, at least min_speed. A line must have begun. O(1).
  double at(double along) const;

 private:
  void slow_in_bends(const MapPolyline& line, const SpeedProfileOptions& options);

  double step_ = 1;  // from sample to sample, m
  double min_speed_ = 0;
  std::vector<double> squared_;  // speeds, at multiples of the step
};

}  // namespace wend
