#pragma once

// The text of docs/planners.md: a part from the registry of planners, which does not depend on the
// machine, and a measured part.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "docs/planner_page/measurements.hpp"
#include "docs/planner_page/pictures.hpp"

namespace wend::planner_page {

/// Where the page keeps the pictures.
inline constexpr std::string_view kImages = "images/planners";

struct Measurements {
  std::vector<MeasuredMap> maps;
  bool with_movingai_maps = false;
  std::string clearance_cost;  // a section's text
  std::string driving;
};

std::string planners_page(std::span<const Picture> pictures, const Measurements& measurements);

/// An earlier page with a new registry part; nothing if the comments around that are missing.
std::optional<std::string> with_new_registry_part(std::string_view page,
                                                  std::span<const Picture> pictures);

}  // namespace wend::planner_page
