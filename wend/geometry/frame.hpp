#pragma once

// Frame: how the grid lies in the world.
//
//   metres = origin + rotate(yaw, resolution * grid)
//
// The origin is the map position of the grid point (0, 0), a corner of cell (0, 0). Where row 0 is
// drawn depends on the file: ROS maps have y up (row 0 is the bottom row of the image), MovingAI
// maps, text grids and bare images have y down (cell (0, 0) is top left).

#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

struct WEND_API Frame {
  double resolution = 1;  // metres a cell, > 0
  MapPose origin{};       // of the grid point (0, 0)
  bool y_up = false;      // row 0 is drawn at the bottom
  bool metric = false;    // the file gave a resolution: numbers from users are in metres

  /// Grid coordinates to metres.
  MapPoint to_metres(Point grid) const;

  /// Metres to grid coordinates.
  Point to_grid(MapPoint metres) const;

  /// The same for poses: the heading turns by the yaw.
  MapPose to_metres(Pose grid) const;
  /// The inverse for poses: the heading turns back by the yaw.
  Pose to_grid(MapPose metres) const;

  /// The cell that a point in metres lies in. Points within 1e-9 m of a cell border belong to the
  /// cell on the greater side, so that 0.3 m at 0.1 m a cell is cell 3 in spite of rounding.
  /// Nothing if the numbers are not finite or too large for a cell.
  std::optional<Cell> cell_at(MapPoint metres) const;

  friend bool operator==(const Frame&, const Frame&) = default;
};

}  // namespace wend
