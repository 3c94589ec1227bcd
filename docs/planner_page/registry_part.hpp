#pragma once

// What the page has from the registry of planners: nothing in it depends on the machine.

#include <span>
#include <string>

#include "docs/planner_page/pictures.hpp"

namespace wend::planner_page {

/// Where the page keeps the pictures.
inline constexpr std::string_view kImages = "images/planners";

/// A table of all planners, then a section for each.
std::string registry_part(std::span<const Picture> pictures);

}  // namespace wend::planner_page
