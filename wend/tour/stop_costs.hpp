#pragma once

// stop_costs(): what the cheapest ways between stops on a session's map cost, for the robot and a planner.
//
//   wend::Session session(map, robot);
//   const auto ways = wend::stop_costs(session, *session.view(), std::array{door, desk, dock}, {});
//   if (!ways) return report(ways.error().message);
//   const auto tour = wend::plan_tour(ways->costs);
//
// Planners that step from cell to cell are answered for by a field of costs for each stop: O(stops x cells). A planner
// with an index (build_index() before) answers every pair in microseconds; others search for every pair.

#include <span>
#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/limits.hpp"
#include "wend/base/workers.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/session.hpp"
#include "wend/tour/cost_matrix.hpp"

namespace wend {

/// How costs between stops are found.
struct StopCostOptions {
  PlannerSpec planner{"astar"};  // its costs, as Plan::cost has them
  Limits limits = {};            // `seconds`, `clock` and `cancel` of the whole call
  Workers* workers = nullptr;    // not owned; null: one thread
  std::vector<std::string> names =
      {};  // what messages call the stops; those without a name are "stop 3"
};

/// Costs between stops, and the stops that spoil a tour of all.
struct StopCosts {
  CostMatrix costs;          // as Plan::cost; CostMatrix::kNoWay where no path exists
  std::vector<int> cut_off;  // stops without a way to or from most of the others, ascending
};

/// The costs between `stops`, poses in metres in the map's frame; planners on cells ignore headings. Fails as
/// Session::planner() does, with start_outside or start_blocked for a stop where the robot cannot be (`where`: its row),
/// with unsupported_query for a pose that is not finite, and with the limit that was reached.
WEND_API Expected<StopCosts, Error> stop_costs(Session& session, const Session::View& view,
                                               std::span<const MapPose> stops,
                                               const StopCostOptions& options = {});

/// "stop 3 is cut off: no path joins it to most others"; empty if no stop is.
WEND_API std::string cut_off_text(const StopCosts& costs);

}  // namespace wend
