#pragma once

// SightPoint: a point inside a free cell, in whole fractions of a cell: where a line of sight begins or ends.
//
//   const wend::SightPoint viewer =
//       wend::SightPoint::at({2.25, 0.5}, {2, 0}, wend::SightPoint::finest(1000));
//
// Lines of sight are found in whole numbers. Centres of cells are exact, in half cells; another point is the nearest
// one of a finer grid, and off the borders of its cell by one step of that grid.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// From one point to another, in the same fractions of a cell.
struct Ray {
  std::int64_t x;
  std::int64_t y;
};

/// Positive if b lies counterclockwise of a, where y points up.
constexpr std::int64_t cross(Ray a, Ray b) { return a.x * b.y - a.y * b.x; }

struct SightPoint {
  Cell cell;
  std::int64_t scale;  // how many steps a cell has: a power of two, 2 for a centre
  std::int64_t x;      // steps
  std::int64_t y;

  /// The centre of a cell.
  static SightPoint centre(Cell cell) {
    return {cell, 2, 2 * std::int64_t{cell.x} + 1, 2 * std::int64_t{cell.y} + 1};
  }

  /// The point of a cell that is nearest to `point`, which the cell contains, in steps of 1 / scale.
  static SightPoint at(Point point, Cell cell, std::int64_t scale) {
    const auto inside = [scale](double value, int low) {
      const auto steps =
          static_cast<std::int64_t>(std::llround(value * static_cast<double>(scale)));
      return std::clamp(steps, scale * low + 1, scale * (std::int64_t{low} + 1) - 1);
    };
    const SightPoint fine{cell, scale, inside(point.x, cell.x), inside(point.y, cell.y)};
    const SightPoint middle = centre(cell);
    return fine.scaled(scale) == middle.scaled(scale) ? middle : fine;
  }

  /// The finest scale for a map whose longer side has so many cells: products of two rays stay whole numbers. About
  /// 1/65536 of a cell on a map of 16,384 cells, never coarser than that of centres.
  static std::int64_t finest(int longer_side) {
    constexpr std::int64_t kMost = std::int64_t{1} << 30;
    constexpr std::int64_t kFinest = std::int64_t{1} << 20;
    std::int64_t scale = 2;
    while (scale < kFinest && 2 * scale * longer_side <= kMost) scale *= 2;
    return scale;
  }

  /// The same point in finer steps.
  SightPoint scaled(std::int64_t finer) const {
    const std::int64_t times = finer / scale;
    return {cell, finer, times * x, times * y};
  }

  /// Grid coordinates.
  Point point() const {
    const auto steps = static_cast<double>(scale);
    return {static_cast<double>(x) / steps, static_cast<double>(y) / steps};
  }

  friend bool operator==(const SightPoint&, const SightPoint&) = default;
};

}  // namespace wend
