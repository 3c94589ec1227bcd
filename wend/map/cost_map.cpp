#include "wend/map/cost_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/geometry/cell.hpp"

namespace wend {

std::optional<std::uint32_t> CostMap::rounded(double multiplier) {
  const double steps = std::floor(multiplier * kOne + 0.5);
  if (!(steps <= static_cast<double>(kMost))) return std::nullopt;
  return std::max(kOne, static_cast<std::uint32_t>(std::max(steps, 0.0)));
}

std::uint32_t CostMap::most_steps() const {
  if (wide_.empty()) return uniform() ? kOne : kMostNarrow;
  const auto all = wide_.values();
  return *std::max_element(all.begin(), all.end());
}

std::size_t CostMap::bytes_per_cell() const {
  if (!narrow_.empty()) return sizeof(std::uint16_t);
  return wide_.empty() ? 0 : sizeof(std::uint32_t);
}

void CostMap::set(Cell cell, std::uint32_t steps) {
  const std::uint32_t before = this->steps(cell);
  if (steps == before) return;
  if (wide_.empty() && steps > kMostNarrow) {
    Grid<std::uint32_t> wide(width_, height_, kOne);
    if (!narrow_.empty()) {
      for (const Cell other : every_cell(wide)) wide[other] = narrow_[other];
      narrow_ = {};
    }
    wide_ = std::move(wide);
  } else if (wide_.empty() && narrow_.empty()) {
    narrow_ = Grid<std::uint16_t>(width_, height_, static_cast<std::uint16_t>(kOne));
  }
  if (wide_.empty()) {
    narrow_[cell] = static_cast<std::uint16_t>(steps);
  } else {
    wide_[cell] = steps;
  }
  if (before == kOne) ++dear_;
  if (steps == kOne) --dear_;
}

bool operator==(const CostMap& a, const CostMap& b) {
  if (a.dear_ != b.dear_) return false;
  if (a.uniform()) return true;
  if (a.width_ != b.width_ || a.height_ != b.height_) return false;
  for (int y = 0; y < a.height_; ++y) {
    for (int x = 0; x < a.width_; ++x) {
      if (a.steps({x, y}) != b.steps({x, y})) return false;
    }
  }
  return true;
}

}  // namespace wend
