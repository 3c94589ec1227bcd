#pragma once

// What the module asks of a planner's PlannerInfo.

#include "wend/planner/planner_info.hpp"

namespace wend::python {

/// Are its paths steps between neighbours?
bool steps_from_cell_to_cell(const PlannerInfo& planner);

/// Does it have an option of this name?
bool has_option(const PlannerInfo& planner, std::string_view name);

}  // namespace wend::python
