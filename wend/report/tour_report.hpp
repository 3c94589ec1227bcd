#pragma once

// Costs between stops and tours for programs: CSV, NumPy's .npy and JSON; and a tour for people.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "wend/geometry/frame.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/report/plan_report.hpp"
#include "wend/tour/cost_matrix.hpp"
#include "wend/tour/plan_tour.hpp"
#include "wend/tour/stop_costs.hpp"
#include "wend/tour/tour_path.hpp"

namespace wend {

/// A row of numbers for each stop, without a header; "inf" where there is no way.
std::string cost_matrix_csv(const CostMatrix& costs);

/// The same as an array of NumPy: float64, C order, little endian.
std::string cost_matrix_npy(const CostMatrix& costs);

/// {"schema", "planner", "stops": 3, "costs": [[0.0, 1.0, null], ...], "cut_off": [2], "times"}. One line.
std::string cost_matrix_json(std::string_view planner, const StopCosts& costs,
                             const WorkTimes& times);

/// A tour and its path. Rows from `stops` on are places that are not in the file of stops: the start and the end.
struct TourReport {
  std::string planner;
  Capabilities capabilities = {};  // of the planner
  bool closed = false;
  std::size_t stops = 0;
  Tour tour;
  TourPath way;
  WorkTimes times = {};  // search: of costs, order and legs
};

/// {"schema", "planner", "status", "closed", "order", "cost", "bound", "kicks", "legs": [{"from", "to", "cost", "first",
/// "last"}], "length_cells", "length_m", "path", "path_m", "times"}. `order`: rows of the stops, from 0. `from` and `to` are null for the
/// start and the end that are not stops; `first` and `last` are indices into the path. One line.
std::string tour_json(const TourReport& report, const Frame& frame);

/// The order, the cost and the bound.
std::string tour_text(const TourReport& report);

}  // namespace wend
