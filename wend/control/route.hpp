#pragma once

// Route: a path in metres, as a follower drives it: legs of one direction each, ahead or in reverse.

#include <optional>
#include <vector>

#include "wend/geometry/frame.hpp"
#include "wend/path/path.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

struct RouteLeg {
  Polyline line;         // metres
  bool reverse = false;  // the robot's back leads
};

class Route {
 public:
  /// Of a path (not empty) in grid coordinates. A car's path has a leg for each stretch between
  /// reversals, and ends with a heading; `closed` is for laps: the end is joined to the start.
  Route(const Path& path, const Frame& frame, bool closed = false);

  const std::vector<RouteLeg>& legs() const { return legs_; }
  double length() const;

  /// The heading in which to end, if it matters: that of the last pose of a car's path.
  std::optional<double> final_heading() const { return final_heading_; }

 private:
  std::vector<RouteLeg> legs_;
  std::optional<double> final_heading_;
};

}  // namespace wend
