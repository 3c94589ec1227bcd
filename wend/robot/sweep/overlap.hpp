#pragma once

// Overlap: how far a robot that does not fit overlaps what blocks it, so that it can be led out: along a way out
// the overlap never grows.
//
// - Of a disc or a point: its depth in cells. With c, the distance from the base point to the nearest blocked square or
//   blocked edge of the map, and d, the distance to the nearest free square if the base point lies in a blocked one,
//   it is r - c outside and r + d inside, and 0 where the disc fits.
// - Of a polygon: the area of blocked squares, and of the blocked outside, that it covers, in square cells.
//
// Both are measured twice: for all that blocks, and without the zones of masks (GridMap::zones()), so that a way out of
// a zone does not lead through a wall.
//
//   const wend::OverlapMeasure measure(space);
//   const bool deeper = measure.at(there).exceeds(measure.at(here));

#include <cmath>
#include <functional>

#include "wend/base/compiler.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// How far a robot overlaps what blocks it: a depth in cells, or an area in square cells.
struct Overlap {
  double all = 0;        // of everything that blocks
  double obstacles = 0;  // of what is not the zone of a mask

  /// Does the robot fit?
  bool none() const { return all <= 0; }
  /// Is one of the two greater, by more than rounding, or is this off the map?
  bool exceeds(const Overlap& other, double rounding = 1e-6) const {
    return std::isinf(all) || all > other.all + rounding || obstacles > other.obstacles + rounding;
  }
  /// The lesser of each.
  Overlap least(const Overlap& other) const {
    return {all < other.all ? all : other.all,
            obstacles < other.obstacles ? obstacles : other.obstacles};
  }
};

/// Measures the overlap of one robot on one space, which must outlive it.
class WEND_API OverlapMeasure {
 public:
  /// Of the space's robot; with `every_heading`, a polygon counts as its circumscribed disc, as planners on cells see it.
  explicit OverlapMeasure(const FreeSpace& space, bool every_heading = false)
      : space_(space), disc_(every_heading || space.outline() == nullptr) {}

  /// At a finite pose, in grid coordinates; infinite if its base point is not on the map. O(cells that the robot covers), and inside
  /// of an obstacle O(squared depth).
  Overlap at(const Pose& pose) const;

 private:
  using Blocks = std::function<bool(Cell)>;

  double depth(Point point, const Blocks& blocks) const;
  double covered(const Pose& pose, const Blocks& blocks) const;

  FreeSpace space_;
  bool disc_;
};

}  // namespace wend
