#pragma once

// How the car's heuristics compare on maps of different kinds.

#include <string>

#include "docs/planner_page/benchmark_maps.hpp"

namespace wend::planner_page {

/// Measures `car` with each of its heuristics, and with a weight: sentences and a table.
std::string driving_section(Effort effort);

}  // namespace wend::planner_page
