#pragma once

// PlacedShape: a robot's shape at a pose, against the squares of cells, by separating axes.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "wend/map/grid_map.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::test {

/// The shape of a robot on a map, placed by its own code.
class PlacedShape {
 public:
  /// `depth`: overlaps that are not deeper, in cells, do not count. The space outlives the shape.
  PlacedShape(const FreeSpace& space, double depth);

  /// The first blocked cell that the shape overlaps at a pose; the cell of the base point if that is not on
  /// the map.
  std::optional<Cell> overlapped_at(const Pose& pose);

 private:
  bool is_blocked(Cell cell) const;
  /// Of a point: are all cells that it touches blocked?
  bool is_inside_obstacles(Point point) const;
  bool overlaps(const Pose& pose, Cell cell) const;

  const GridMap& map_;
  bool unknown_blocked_;
  bool outside_blocked_;
  double depth_;
  double radius_;               // of a disc, or of the circumscribed disc
  std::vector<Point> corners_;  // of a polygon, in cells; else empty
  std::vector<Point> placed_;   // the same at the pose
};

}  // namespace wend::test
