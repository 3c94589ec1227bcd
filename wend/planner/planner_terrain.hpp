#pragma once

// What a planner makes of terrain, in words.

#include <string_view>

#include "wend/planner/planner_info.hpp"

namespace wend {

/// "costs count", "ignored" or "refused".
std::string_view terrain_in_words(const PlannerInfo& planner);

}  // namespace wend
