#pragma once

// Trajectory: a path with time stamps and speeds: where the robot is at each moment, and how fast it
// drives and turns. It is the fastest one along the path within the limits, from rest to rest.
//
//   const wend::TrajectoryLimits limits{.speed = 0.4, .acceleration = 0.5};
//   const auto trajectory = wend::Trajectory::along(path, frame, limits);
//   if (!trajectory) return report(trajectory.error().message);
//   const wend::TrajectoryState state = trajectory->at(trajectory->duration() / 2);
//
// Metres, radians and seconds, in the map's frame. The robot drives the segments of the path: lines,
// arcs, turns in place and steps to the side. It stops at every corner of a path of cells or waypoints,
// where it turns in place; and on a path of poses where the direction of travel jumps by more than 10
// degrees, as between ahead and reverse. (Smaller jumps occur between motion primitives that end on
// whole cells.) rounded_corners() replaces corners by arcs, which are driven without a stop.
//
// On a segment with curvature c, the speed v has three limits: the speed itself, turn_rate / |c|, and
// the root of lateral_acceleration / |c|. These are constant on each segment, so the optimum has at
// most three stretches on it: accelerate, hold, brake. A forward and a backward pass over the joints
// of the segments find the speeds there (speed_passes.hpp). This is exact: no limit is exceeded, and
// a higher speed anywhere would exceed one. The turn rate jumps where the curvature jumps.
//
// J. Bobrow, S. Dubowsky and J. Gibson, "Time-Optimal Control of Robotic Manipulators Along Specified
// Paths", 1985; S. LaValle, "Planning Algorithms", 2006, section 14.6.3.
//
// through() takes a trajectory from elsewhere, as poses with time stamps, as it is.
//
// Immutable; threads may share it.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// What limits speeds; all finite, greater than 0. Names and defaults are those of VelocityLimits.
struct WEND_API TrajectoryLimits {
  double speed = 0.5;               // m/s, ahead and in reverse
  double turn_rate = 1.5;           // rad/s
  double acceleration = 1;          // m/s^2 along the path, also for braking
  double turn_acceleration = 5;     // rad/s^2, of turns in place
  double lateral_acceleration = 1;  // m/s^2 in curves

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"speed", "upper limit on the speed, m/s"}, self.speed, {1e-3, 1e3});
    field({"turn_rate", "upper limit on the turn rate, rad/s"}, self.turn_rate, {1e-3, 1e3});
    field({"acceleration", "upper limit on acceleration and braking, m/s^2"}, self.acceleration,
          {1e-3, 1e6});
    field(
        {"turn_acceleration", "upper limit on the angular acceleration of turns in place, rad/s^2"},
        self.turn_acceleration, {1e-3, 1e6});
    field({"lateral_acceleration", "upper limit on the lateral acceleration in curves, m/s^2"},
          self.lateral_acceleration, {1e-3, 1e3});
  }
};

/// The highest speed on a curvature (1/m), without regard to what lies before and behind it.
WEND_API double fastest_on(double curvature, const TrajectoryLimits& limits);

/// The robot at one moment.
struct TrajectoryState {
  double time = 0;       // s since the start
  MapPose pose;          // in the map's frame
  double speed = 0;      // m/s, of the base point; negative in reverse; of a step to the side along
                         // its course
  double turn_rate = 0;  // rad/s, positive where the heading grows
};

/// Where a robot is to be at a time.
struct TimedPose {
  double time = 0;  // s
  MapPose pose;     // in the map's frame
};

/// A stretch of one segment at constant acceleration. The speed here is never negative.
struct TrajectoryPiece {
  std::size_t segment = 0;  // of Trajectory::segments()
  double time = 0;          // s, of its beginning
  double duration = 0;      // s, > 0
  double along = 0;         // where on the segment it begins, m; of a turn in place radians
  double speed = 0;         // at its beginning, m/s; of a turn in place rad/s
  double acceleration = 0;  // m/s^2, negative for braking; of a turn in place rad/s^2
};

class WEND_API Trajectory {
 public:
  /// The most states that samples() returns.
  static constexpr std::size_t kMostSamples = 10'000'000;

  /// The fastest trajectory along a path, which is in grid coordinates; `frame` is its map's. The path
  /// is not checked for collisions. Errors: invalid_option for a limit that is not finite or not
  /// greater than 0, unsupported_query for a path with a fault (path_fault.hpp) or too long to be timed, time_limit or
  /// cancelled if the deadline passes before it is done. O(segments).
  static Expected<Trajectory, Error> along(const Path& path, const Frame& frame,
                                           const TrajectoryLimits& limits = {},
                                           const Deadline& deadline = {});

  /// A trajectory from another source, through poses with time stamps, from the first stamp on. Between
  /// two poses the robot drives their shortest segment at a constant speed, or waits if they are equal.
  /// limits() are then the highest speed and turn rate that it has, and no limits on accelerations.
  /// Errors: unsupported_query without poses, for numbers that are not finite, for stamps that do not increase, and
  /// for poses so far apart that its speed would not be finite. O(poses).
  static Expected<Trajectory, Error> through(std::span<const TimedPose> poses);

  /// The time from the start to the end, s.
  double duration() const { return duration_; }

  /// The way of the base point, m.
  double length() const;

  /// The radius of the tightest curve, m; 0 with a turn in place, infinite on a line. A robot that
  /// steers needs a trajectory whose radius is at least its own.
  double smallest_turning_radius() const;

  /// The state at a time; before the start and after the end the robot stands there. NaN counts as 0. O(log pieces).
  TrajectoryState at(double time) const;

  /// The states at 0, period, 2 period, ... (period > 0), and at the end; the one before the end is at least
  /// a millionth of a period earlier. None for a period that is NaN, not above 0, or so short that they would be more
  /// than kMostSamples. O(duration / period).
  std::vector<TrajectoryState> samples(double period) const;

  /// What it drives, in metres: the segments of the path, with turns in place at its corners. None of
  /// them goes nowhere, except where the robot waits between two time stamps.
  std::span<const MapSegment> segments() const { return segments_; }

  /// Their time stamps and speeds, in order, without gaps.
  std::span<const TrajectoryPiece> pieces() const { return pieces_; }

  /// The limits that it keeps.
  const TrajectoryLimits& limits() const { return limits_; }

 private:
  void drive_for(double seconds, const MapSegment& segment);
  void drive(std::size_t segment, double squared_before, double squared_after);
  TrajectoryState state_on(const TrajectoryPiece& piece, double seconds) const;

  TrajectoryLimits limits_;
  std::vector<MapSegment> segments_;
  std::vector<TrajectoryPiece> pieces_;
  MapPose start_;
  MapPose end_;
  double duration_ = 0;
};

}  // namespace wend
