#pragma once

// The registry of planners, for people and for programs.

#include <span>
#include <string>

#include "wend/base/registry.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

/// A table with a line for each planner: its name, its guarantee in a word, what it plans for and what it does. At most
/// 80 columns as long as summaries have at most 44.
std::string planner_table(const Registry<PlannerInfo>& planners);

/// Each planner with what it guarantees and costs, when to choose it, its options with ranges and
/// defaults, and its paper. Paragraphs have at most 90 columns.
std::string planner_listing_text(const Registry<PlannerInfo>& planners);

/// A list of {"name", "summary", "idea", "guarantee", "promise", "time", "memory", "when",
/// "motion", "plans_on_terrain", "preprocessing", "can_step", "citation", "options"}. One line with its line
/// end.
std::string planner_listing_json(const Registry<PlannerInfo>& planners);

/// The range of an option: "0 to 1e+06", "4 or 8", "true or false".
std::string range_text(const OptionInfo& option);

}  // namespace wend
