#pragma once

// Route: a path in metres, as a follower drives it: legs of one direction each, ahead or in reverse.
//
//   const wend::Route route(plan->path, space.map().frame());
//   for (const wend::RouteLeg& leg : route.legs()) metres += leg.line.length();

#include <optional>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/path/path.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// The pose, or, if `reverse`, the pose turned by pi: on a reverse leg the controller sees the
/// robot turned round.
WEND_API MapPose turned_round(const MapPose& pose, bool reverse);

/// A part of a route that is driven in one direction.
struct RouteLeg {
  MapPolyline line;         // in the direction of travel
  bool reverse = false;     // the robot's back leads
  bool turn_first = false;  // the robot turns in place before it
  double course =
      0;  // rad, to the left of the leading end: of a leg that an omni robot drives to its side
};

/// A robot as the controller of a leg sees it: so that its heading is the direction of travel.
WEND_API MapPose shown_on(const RouteLeg& leg, const MapPose& pose);
/// The same back: the pose of a robot that is shown so.
WEND_API MapPose seen_on(const RouteLeg& leg, const MapPose& shown);

/// Where a path first steps to a side of the robot, by more than 10 degrees, in grid coordinates: only an omni robot
/// can do that. O(n).
WEND_API std::optional<Pose> first_step_aside(const Path& path);

/// Where a path of poses first turns in place, at its ends too, or jumps from one direction of travel to another one,
/// in grid coordinates: a robot that steers cannot do that. Nothing for a path of lines. O(n).
WEND_API std::optional<Pose> first_turn_in_place(const Path& path);

/// Where a path of poses first has an arc of a smaller radius, in cells, by more than what a controller evens out (1.1
/// degrees), in grid coordinates. Nothing for a path of lines. O(n).
WEND_API std::optional<Pose> first_bend_tighter_than(double radius, const Path& path);

class WEND_API Route {
 public:
  /// Farther from the origin of the map's frame there is no place of a route, m.
  static constexpr double kFarthest = 1e8;

  /// Points that are no farther apart are one place: what lies between has no direction, m.
  static constexpr double kSamePlace = 1e-6;

  /// A heading is no larger: more turns than that are a mistake, rad.
  static constexpr double kLargestHeading = 1e6;

  /// How many lines the arcs of a path may become, besides a few for each: tens of kilometres of bends.
  static constexpr int kMostChords = 1 << 18;

  /// Is it finite, and not farther than kFarthest?
  static bool can_hold(MapPoint point);
  /// Is it finite, and no larger than kLargestHeading?
  static bool can_hold(double heading);

  /// The route of a path (not empty) in grid coordinates. A path of poses has a leg for each stretch
  /// between reversals and turns in place, however small, its arcs within 0.01 cells and a millimetre (more if these would
  /// be more than kMostChords lines), and ends with a heading. `closed` is for laps: a straight line, driven forwards, joins the end to the start.
  /// A path with a place that no route can hold gives a route that is not valid().
  Route(const Path& path, const Frame& frame, bool closed = false);

  /// A route of these legs, at least one. `final_heading` is the heading at the end, if one is asked for.
  explicit Route(std::vector<RouteLeg> legs, std::optional<double> final_heading = {});

  /// Can a robot drive it: can it hold each place and each heading? A route that is not
  /// valid has one leg, the origin.
  bool valid() const { return valid_; }

  /// The legs, in the order in which they are driven; at least one. Successive points of their lines are
  /// farther apart than kSamePlace.
  const std::vector<RouteLeg>& legs() const { return legs_; }
  /// The length of all legs, m.
  double length() const;

  /// The robot's pose at the route's start: along its first line; for a car, the first pose of its path.
  const MapPose& start() const { return start_; }
  /// The robot's pose at the route's end: along its last line; for a car, the last pose of its
  /// path.
  const MapPose& end() const { return end_; }

  /// The heading at the end, if the path has one: that of the last pose of a car's path.
  std::optional<double> final_heading() const { return final_heading_; }

 private:
  void follow(const JoinedPoses& joined, const Frame& frame, bool closed);
  void set_ends(const MapPose& start);
  void invalidate();

  std::vector<RouteLeg> legs_;
  MapPose start_;
  MapPose end_;
  std::optional<double> final_heading_;
  bool valid_ = true;
};

}  // namespace wend
