#pragma once

// PointSweep: moves a point along lines and arcs, one after the other, and says where it can go no
// farther. It is what a robot of radius 0 does.
//
//   wend::PointSweep sweep(space, {0.5, 0.5});
//   if (!sweep.go_to({3.5, 1.5})) report("blocked");
//
// The point keeps out of the union of the obstacles' closed squares: it may touch edges and corners,
// but an edge between two obstacles, or a corner of four, is inside. At a corner where exactly two
// obstacles touch, diagonally, it may come and go on the same side, but not pass from one side to
// the other, whether inside a line or where two lines meet; unless `adjacency` is
// edges_and_corners. Cells outside the map are no obstacles.
//
// Exact, but that kPointTolerance is rounding: so near to its edge, the inside of an obstacle counts
// as the edge. Lines between centres of cells on maps of up to 10^8 columns are thus decided exactly,
// and paths still fit that were written down in metres and read again.

#include <optional>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/line.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

inline constexpr double kPointTolerance = 1e-9;  // cells

class PointSweep {
 public:
  /// Starts at a finite point in grid coordinates. The space outlives the sweep.
  PointSweep(const FreeSpace& space, Point start, Adjacency adjacency = Adjacency::edges)
      : space_(&space), adjacency_(adjacency), at_(start) {}

  /// On along a line, or along an arc that begins where the point is. False if the way is not
  /// free, the point where it begins included; the sweep is then over. O(1) where the clearance of
  /// a cell shows the way to be free, else O(rows that it crosses).
  bool go_to(Point to);
  bool go_along(const Arc& arc);

 private:
  bool passes_its_gap(Point before, Point after) const;
  void arrive(Point to);

  const FreeSpace* space_;  // never null
  Adjacency adjacency_;
  Point at_;
  std::optional<Point> before_gap_;  // from where it came, if it is in a gap
};

/// Is this point, up to rounding, a corner at which exactly two obstacles touch, diagonally?
bool in_gap(const FreeSpace& space, Point point);

}  // namespace wend
