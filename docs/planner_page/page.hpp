#pragma once

// The page as a whole.

#include <span>
#include <string>
#include <vector>

#include "docs/planner_page/clearance_cost.hpp"
#include "docs/planner_page/drives.hpp"
#include "docs/planner_page/measured_family.hpp"
#include "docs/planner_page/pictures.hpp"

namespace wend::planner_page {

struct Measurements {
  std::vector<MeasuredFamily> families;  // on maps with paths
  MeasuredFamily small;                  // every planner, random walks too
  MeasuredFamily no_path;
  ClearanceCostStudy clearance_distance;
  DriveStudy drives;
  bool with_data = false;  // are there families on maps that are not our own?
};

/// Between these lines stands what comes from the registry.
inline constexpr std::string_view kRegistryBegins = "<!-- from the registry -->";
inline constexpr std::string_view kRegistryEnds = "<!-- measured -->";

/// The text of planners.md.
std::string page(std::span<const Picture> pictures, const Measurements& measurements);

}  // namespace wend::planner_page
