#pragma once

// How two planners compare, map by map.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "docs/planner_page/measured_family.hpp"

namespace wend::planner_page {

using Measured = double MeasuredPlanner::*;

/// One number for a map.
struct OnMap {
  const MeasuredFamily* family;
  double value;

  std::string title() const;  // "*Maze*"
};

/// A number of one planner on every map that has it.
std::vector<OnMap> values_of(std::span<const MeasuredFamily> families, std::string_view role,
                             Measured number);

/// A number of one planner over that of another, on every map that has both.
std::vector<OnMap> ratios(std::span<const MeasuredFamily> families, std::string_view role,
                          std::string_view other, Measured number);

/// Of at least one value.
const OnMap& least_of(const std::vector<OnMap>& values);
const OnMap& greatest_of(const std::vector<OnMap>& values);

/// The maps whose value is less than `limit`.
std::vector<OnMap> below(const std::vector<OnMap>& values, double limit);

/// "*Maze* and *Rooms*"
std::string titles(const std::vector<OnMap>& values);

/// "2 to 5", or "2" where both read the same.
std::string range_of(const std::vector<OnMap>& values, std::string (*text)(double));

/// The maps that are on uniform terrain and have 8 neighbours.
std::vector<MeasuredFamily> plain_families(std::span<const MeasuredFamily> families);

}  // namespace wend::planner_page
