#pragma once

// The findings that are about one input: 4 neighbours, terrain, clearance, a walk, no path.

#include <string>

#include "docs/planner_page/page.hpp"

namespace wend::planner_page {

/// As findings().
std::string situation_findings(const Measurements& measurements);

}  // namespace wend::planner_page
