#pragma once

// Box: an upright rectangle, closed.
//
//   wend::Box box(line.from);
//   box.include(line.to);

#include <algorithm>

#include "wend/geometry/pose.hpp"

namespace wend {

struct Box {
  Point low;
  Point high;

  explicit Box(Point point) : low(point), high(point) {}

  void include(Point point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }

  Box grown_by(double margin) const {
    Box box({low.x - margin, low.y - margin});
    box.include({high.x + margin, high.y + margin});
    return box;
  }
};

}  // namespace wend
