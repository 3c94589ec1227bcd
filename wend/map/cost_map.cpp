#include "wend/map/cost_map.hpp"

#include <algorithm>
#include <utility>

#include "wend/geometry/cell.hpp"

namespace wend {

std::uint32_t CostMap::most_steps() const {
  if (wide_.empty()) return uniform() ? kOne : kMostNarrow;
  const auto all = wide_.values();
  return *std::max_element(all.begin(), all.end());
}

std::size_t CostMap::bytes_per_cell() const {
  if (!narrow_.empty()) return sizeof(std::uint16_t);
  return wide_.empty() ? 0 : sizeof(std::uint32_t);
}

void CostMap::make_room(std::uint32_t most) {
  if (!wide_.empty()) return;
  if (most > kMostNarrow) {
    Grid<std::uint32_t> wide(width_, height_, kOne);
    for (int y = 0; y < height_ && !narrow_.empty(); ++y) {
      std::ranges::copy(narrow_.row(y), wide.row(y).begin());
    }
    wide_ = std::move(wide);
    narrow_ = {};
  } else if (narrow_.empty()) {
    narrow_ = Grid<std::uint16_t>(width_, height_, static_cast<std::uint16_t>(kOne));
  }
}

void CostMap::set_row(int y, std::span<const std::uint32_t> steps) {
  std::uint32_t most = kOne;
  std::size_t dear = 0;
  for (const std::uint32_t each : steps) {
    most = std::max(most, each);
    dear += each == kOne ? 0 : 1;
  }
  if (dear == 0) return;
  dear_ += dear;
  make_room(most);
  if (wide_.empty()) {
    std::ranges::transform(steps, narrow_.row(y).begin(),
                           [](std::uint32_t each) { return static_cast<std::uint16_t>(each); });
  } else {
    std::ranges::copy(steps, wide_.row(y).begin());
  }
}

void CostMap::set(Cell cell, std::uint32_t steps) {
  const std::uint32_t before = this->steps(cell);
  if (steps == before) return;
  make_room(steps);
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
