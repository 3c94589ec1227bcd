#pragma once

// --planner: a planner by name, or several, each with options: "astar", "astar:weight=2,bfs".

#include <string>
#include <string_view>
#include <vector>

#include "wend/planner/planner_info.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

/// The planners of a list. Throws InputError for one that does not exist and for text that is no
/// option.
std::vector<PlannerSpec> parse_planners(const std::string& text);

/// The same where only one may stand.
PlannerSpec parse_planner(const std::string& text);

const PlannerInfo& info_of(const PlannerSpec& planner);

/// Of a car: how many map cells apart the corners lie on which it stands, as far as its options say.
int unit_of(const PlannerSpec& planner, const Frame& frame);

/// Has a planner or smoother an option of that name?
bool has_option(const std::vector<OptionInfo>& options, std::string_view name);

}  // namespace wend::cli
