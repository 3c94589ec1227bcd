#pragma once

// What planning with a clearance cost gives and costs: clearance against length and time.

#include <string>

#include "docs/planner_page/benchmark_maps.hpp"

namespace wend::planner_page {

/// Measures astar in an office with several clearance distances: a sentence and a table.
std::string clearance_cost_section(Effort effort);

}  // namespace wend::planner_page
