#pragma once

// FootprintRows: a robot's polygon, grown by a margin, as an interval of cells in each row of the map, and whether
// any of these cells is blocked: 64 cells at a time.

#include <span>
#include <vector>

#include "wend/geometry/polygon.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// Does a polygon, whose corners are given counterclockwise, have no hollow?
bool is_convex(std::span<const Point> corners);

class FootprintRows {
 public:
  /// Nothing, for a robot without a polygon.
  FootprintRows() = default;
  explicit FootprintRows(const Polygon& outline);

  bool empty() const { return corners_.empty(); }

  /// Without a hollow, what the rows cover is exactly what the polygon covers.
  bool convex() const { return convex_; }

  /// Is a cell blocked that the polygon, grown by a margin in cells, may overlap at this pose? Never false where it
  /// does overlap one. For a convex polygon and a margin of 0, true only if it overlaps one. A cell outside the map
  /// counts as blocked if the robot may not hang over the edge. O(corners + rows that edges pass + cells / 64).
  bool meet_obstacle(const FreeSpace& space, const Pose& pose, double margin) const;

 private:
  std::vector<Point> corners_;
  bool convex_ = true;
};

}  // namespace wend
