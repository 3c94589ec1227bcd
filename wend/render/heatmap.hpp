#pragma once

// Heatmap: a number for every cell of a map, shown as a colour or as text.

#include <optional>
#include <string>

#include "wend/map/grid.hpp"

namespace wend {

/// The range of numbers that the colours of a heatmap span.
struct HeatRange {
  double least = 0;
  double greatest = 0;

  /// The share of a number from the least (0) to the greatest (1), clamped. 0 if least and greatest
  /// are equal.
  double share(double value) const;

  friend bool operator==(const HeatRange&, const HeatRange&) = default;
};

/// A number for every cell, drawn as a colour between those of the least and the greatest.
struct Heatmap {
  std::string title;    // "order of expansion"
  Grid<double> values;  // as large as the map; no colour where a value is not finite
  /// The range of the colours, to compare pictures; values outside take the colour of the nearer
  /// end. Unset: from the least to the greatest finite value.
  std::optional<HeatRange> range{};
};

/// The heatmap's range, or that of its values if unset; nothing if no value is finite.
/// O(cells).
std::optional<HeatRange> range_of(const Heatmap& heatmap);

/// One number, short: "8321", "0.25", "1.25e6".
std::string short_number(double number);

/// The finite numbers of a grid with as many decimals as are needed, at most two: "0", "1.41".
class NumberText {
 public:
  explicit NumberText(const Grid<double>& numbers);

  std::string operator()(double number) const;

  /// The characters of the longest number; 0 if no value is finite.
  int columns() const { return columns_; }

 private:
  int decimals_ = 0;
  int columns_ = 0;
};

}  // namespace wend
