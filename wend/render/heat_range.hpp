#pragma once

// HeatRange: the numbers between which the colours of a heatmap lie.

#include <optional>

#include "wend/map/grid.hpp"

namespace wend {

struct Heatmap;

struct HeatRange {
  double least = 0;
  double greatest = 0;

  /// How far a number lies from the least (0) to the greatest (1); ones outside take the nearer
  /// end. 0 for all if there is but one number.
  double share(double value) const;

  friend bool operator==(const HeatRange&, const HeatRange&) = default;
};

/// From the least to the greatest finite value; nothing if no value is finite. O(cells).
std::optional<HeatRange> range_of(const Grid<double>& values);

/// The range that a heatmap asks for, or else that of its values.
std::optional<HeatRange> range_of(const Heatmap& heatmap);

}  // namespace wend
