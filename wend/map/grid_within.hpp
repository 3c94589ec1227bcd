#pragma once

// grid_within(): a large grid that is filled piece by piece, so that a deadline can end that.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "wend/base/deadline.hpp"
#include "wend/map/grid.hpp"

namespace wend {

/// The same value in every cell; no cells if the deadline passes before.
template <class T>
Grid<T> grid_within(int width, int height, T value, DeadlineCheck& stop) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 18U;
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<T> values;
  values.reserve(count);
  while (values.size() < count && !stop.now()) {
    values.resize(std::min(values.size() + kAtOnce, count), value);
  }
  if (stop.has_passed()) return {};
  return {width, height, std::move(values)};
}

}  // namespace wend
