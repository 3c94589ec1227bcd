#pragma once

// Box: an upright rectangle, closed.
//
//   wend::Box box(line.from);
//   box.include(line.to);

#include <algorithm>

#include "wend/geometry/pose.hpp"

namespace wend {

struct Box {
  Point low;   // the smaller coordinates
  Point high;  // the larger coordinates

  /// The box that contains one point.
  explicit Box(Point point) : low(point), high(point) {}

  /// Grows to contain a point.
  void include(Point point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }

  /// The box with this margin (>= 0) on every side.
  Box grown_by(double margin) const {
    Box box({low.x - margin, low.y - margin});
    box.include({high.x + margin, high.y + margin});
    return box;
  }
};

}  // namespace wend
