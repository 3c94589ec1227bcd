#include "wend/render/heat_range.hpp"

#include <algorithm>
#include <cmath>

#include "wend/render/scene.hpp"

namespace wend {

double HeatRange::share(double value) const {
  if (!(least < greatest)) return 0;
  // Halves, as the whole span may be more than a double holds.
  return std::clamp((value / 2 - least / 2) / (greatest / 2 - least / 2), 0.0, 1.0);
}

std::optional<HeatRange> range_of(const Grid<double>& values) {
  std::optional<HeatRange> range;
  for (const double value : values.values()) {
    if (!std::isfinite(value)) continue;
    if (!range) range = {value, value};
    range->least = std::min(range->least, value);
    range->greatest = std::max(range->greatest, value);
  }
  return range;
}

std::optional<HeatRange> range_of(const Heatmap& heatmap) {
  return heatmap.range ? heatmap.range : range_of(heatmap.values);
}

}  // namespace wend
