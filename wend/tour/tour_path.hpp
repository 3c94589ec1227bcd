#pragma once

// tour_path(): the legs of a tour, planned one after the other and joined to one path.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/path/path.hpp"
#include "wend/session/session.hpp"
#include "wend/tour/plan_tour.hpp"
#include "wend/tour/stop_costs.hpp"

namespace wend {

/// The way from one stop of a tour to the next.
struct TourLeg {
  int from;  // rows of the stops
  int to;
  double cost;
  std::size_t
      first;  // its cells, waypoints or poses in the path, inclusive; the next leg begins where it ends
  std::size_t last;
};

/// All legs of a tour as one path, in grid coordinates.
struct TourPath {
  Path path;
  std::vector<TourLeg> legs;
};

/// The path of an order of stops. Planners with headings start a leg with the heading of its stop. Fails as
/// stop_costs() does, and with the status of a leg that has no path (`where`: "leg 3").
WEND_API Expected<TourPath, Error> tour_path(Session& session, const Session::View& view,
                                             std::span<const MapPose> stops,
                                             std::span<const int> order, bool closed,
                                             const StopCostOptions& options = {});

}  // namespace wend
