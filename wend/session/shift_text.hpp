#pragma once

// How far the ends of a path are from where they were asked to be, in words, as every front end says it.
//
//   const wend::Units units(space.map());
//   report(wend::shifts_text(plan.start_snapping_error, plan.goal_snapping_error, units));

#include <string>

#include "wend/base/compiler.hpp"
#include "wend/planner/plan.hpp"
#include "wend/session/units.hpp"

namespace wend {

/// "1 cell and 40 degrees from what was asked"; empty for a mere rounding error.
WEND_API std::string shift_text(const SnappingError& error, const Units& units);

/// The same of both ends: "the start 0.35 m from what was asked, the goal 0.1 m from what was asked"; empty if both are
/// where they were asked to be.
WEND_API std::string shifts_text(const SnappingError& start, const SnappingError& goal,
                                 const Units& units);

}  // namespace wend
