#pragma once

// Route: a path in metres, as a follower drives it: legs of one direction each, ahead or in reverse.
//
//   const wend::Route route(plan->path, space.map().frame());
//   for (const wend::RouteLeg& leg : route.legs()) metres += leg.line.length();

#include <optional>
#include <vector>

#include "wend/geometry/frame.hpp"
#include "wend/path/path.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// A pose, or the same facing backwards: how the robot stands, and how its controller sees it, on a leg
/// that is driven in reverse.
Pose turned_round(const Pose& pose, bool reverse);

struct RouteLeg {
  Polyline line;         // metres
  bool reverse = false;  // the robot's back leads
};

class Route {
 public:
  /// Of a path (not empty) in grid coordinates. A car's path has a leg for each stretch between
  /// reversals, its arcs within 0.01 cells, and ends with a heading. `closed` is for laps: a straight
  /// line, driven ahead, joins the end to the start.
  Route(const Path& path, const Frame& frame, bool closed = false);

  const std::vector<RouteLeg>& legs() const { return legs_; }
  double length() const;

  /// How the robot stands where the route begins and where it ends: along its first and last line;
  /// of a car's path as its poses say.
  const Pose& start() const { return start_; }
  const Pose& end() const { return end_; }

  /// The heading in which to end, if the path says so: that of the last pose of a car's path.
  std::optional<double> final_heading() const { return final_heading_; }

 private:
  std::vector<RouteLeg> legs_;
  Pose start_;
  Pose end_;
  std::optional<double> final_heading_;
};

}  // namespace wend
