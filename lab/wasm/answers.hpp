#pragma once

// The answers of a Lab as JSON.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "lab/wasm/painting/replay.hpp"
#include "wend/base/error.hpp"
#include "wend/path/path.hpp"
#include "wend/session/plan_request.hpp"

namespace wend::lab {

/// A path of an anytime planner.
struct Solution {
  double cost;
  double bound;
  std::uint32_t step;  // the expansions until then
  Path path;           // grid coordinates
  std::size_t points;  // of it, as the page draws it
};

/// {"error": message, "status": status}
std::string error_text(const Error& error);

/// A failed search: the same with the work of the search and the number of steps that can be replayed.
std::string failure_text(const RequestFailure& failure, std::uint32_t steps);

/// A path: its cost, its bound, how it was led out or where it ends in place of the goal, the work of the search, and the
/// solutions on the way to it. `lead_points` are those of its way out, as the page draws it.
std::string plan_text(const PlanAnswer& answer, std::uint32_t steps,
                      std::span<const Solution> solutions, std::size_t lead_points);

/// A cell: what is there, whether the robot fits, what the search knew of it.
std::string cell_text(const FreeSpace& space, Cell cell, std::uint8_t byte, const Replay& replay);

}  // namespace wend::lab
