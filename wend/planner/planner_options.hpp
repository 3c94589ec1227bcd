#pragma once

// Planners from typed options: a struct for every planner of the library that has options. Its fields are the
// options that make_planner() takes as text, with the same names, defaults and ranges.
//
//   const auto planner = wend::make_planner(space, wend::AStarOptions{.weight = 2});
//   if (!planner) return report(planner.error().message);
//
//   request.planner = wend::planner_spec(wend::AStarOptions{.weight = 2});

#include <string>
#include <string_view>

#include "wend/base/option_values.hpp"
#include "wend/planner/any_angle/any_angle_options.hpp"
#include "wend/planner/grid/grid_options.hpp"
#include "wend/planner/incremental/incremental_options.hpp"
#include "wend/planner/lattice/lattice_options.hpp"
#include "wend/planner/planners.hpp"
#include "wend/planner/se2/hybrid_astar_options.hpp"

namespace wend {

/// An option struct with the name of its planner. One of yours works too, for a planner of yours.
template <class Options>
concept PlannerOptions = requires { std::string_view(Options::kPlanner); };

/// A planner's name and options as text, as a PlanRequest takes them.
template <PlannerOptions Options>
PlannerSpec planner_spec(const Options& options) {
  return {std::string(Options::kPlanner), option_values(options)};
}

/// Makes the planner of these options; a value out of its range is Status::invalid_option.
template <PlannerOptions Options>
PlannerResult make_planner(const FreeSpace& space, const Options& options) {
  return make_planner(Options::kPlanner, space, option_values(options));
}

}  // namespace wend
