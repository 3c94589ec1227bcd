#pragma once

// Where a robot joins a route that it gets while it is somewhere in the middle of it: after a pause, when a
// path is sent again, after the path has changed.
//
//   const auto place = wend::place_to_join(route, pose, {.within = 1, .tie = 0.15});
//   if (place) metres_behind = place->along;  // of the leg place->leg

#include <cstddef>
#include <functional>
#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/control/route.hpp"
#include "wend/geometry/map_pose.hpp"

namespace wend {

/// Can the robot get from a pose to a point along a straight line, as far as is known?
using FreeLine = std::function<bool(const MapPose& from, MapPoint to)>;

/// Which places of a route come into question.
struct JoiningOptions {
  double within = 1;  // m: no place is farther from the robot
  double tie =
      0.15;  // m: places that are farther than the nearest by no more than this are as near
  FreeLine can_reach{};  // empty: every place can be reached
};

/// A place on a route.
struct OnRoute {
  std::size_t leg = 0;  // the index of the leg
  double along = 0;     // m, on that leg
  double distance = 0;  // m, from the robot
};

/// The nearest place that the robot can reach. Where the route comes as near several times, it is the first of
/// these visits if the route begins there, else the first that leads the way the robot faces, else the first.
/// Nothing if no place is near enough and can be reached. O(lines) for each place that it asks about, the nearest first;
/// takes no memory.
WEND_API std::optional<OnRoute> place_to_join(const Route& route, const MapPose& pose,
                                              const JoiningOptions& options = {});

/// Are they the same legs, but for rounding? O(points).
WEND_API bool same_route(const Route& a, const Route& b);

}  // namespace wend
