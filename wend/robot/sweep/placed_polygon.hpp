#pragma once

// PlacedPolygon: a robot's polygon at a pose, in grid coordinates, and whether it overlaps the squares
// of cells there or while it moves along a line.
//
//   const wend::PlacedPolygon robot(outline_in_cells, {3.5, 2.5, heading});
//   if (robot.overlaps(wend::Cell{4, 2})) ...
//
// "Overlaps" refers to the interior of a square: a polygon may touch its edges and corners. Exact, except
// that a polygon that enters a square by less than kOverlapTolerance only touches it. O(corners).

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/box.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/polygon.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

inline constexpr double kOverlapTolerance = 1e-9;  // cells

class WEND_API PlacedPolygon {
 public:
  /// The polygon, in cells, turned and moved to a pose in grid coordinates. At a pose that contains NaN or
  /// infinity it overlaps every square.
  PlacedPolygon(const Polygon& polygon, const Pose& pose);

  /// The corners in grid coordinates.
  std::span<const Point> corners() const {
    return size_ <= kFew ? std::span<const Point>(few_.data(), size_) : many_;
  }

  /// The box around all corners.
  const Box& box() const { return box_; }

  /// Does the polygon overlap the square of a cell?
  bool overlaps(Cell square) const { return overlaps_along({0, 0}, square); }

  /// The first side that enters the square of a cell: that from this corner to the next one. Nothing if they do not
  /// overlap, or if the polygon covers the whole square.
  std::optional<std::size_t> side_across(Cell square) const;

  /// Does the polygon overlap the square somewhere while it moves by `by`, without turning?
  bool overlaps_along(Point by, Cell square) const;

  /// The distance to the closed square; 0 if they touch or overlap.
  double distance_to(Cell square) const;

 private:
  static constexpr std::size_t kFew = 64;  // corners that need no memory of their own

  Line edge(std::size_t i) const {
    const std::span<const Point> all = corners();
    return {all[i], all[i + 1 == size_ ? 0 : i + 1]};
  }

  std::array<Point, kFew> few_;
  std::vector<Point> many_;
  std::size_t size_;
  Box box_;
};

}  // namespace wend
