#pragma once

// PointSweep: moves a point, a robot of radius 0, along lines and arcs, one after the other, and says
// where it is blocked.
//
//   wend::PointSweep sweep(space, {0.5, 0.5});
//   if (!sweep.go_to({3.5, 1.5})) report("blocked");
//
// The point must stay out of the interior of the union of the obstacles' closed squares: it may touch
// edges and corners, but an edge between two obstacles, or a corner of four, is inside. At a corner
// where exactly two obstacles touch, diagonally, it may come and go on the same side, but not pass from
// one side to the other, whether inside a line or where two lines meet; unless `adjacency` is
// edges_and_corners. Cells outside the map are not obstacles.
//
// Exact, except that the interior of an obstacle within kPointTolerance of its edge counts as the edge.
// So lines between centres of cells on maps of up to 10^8 columns are decided exactly, and paths that
// were saved in metres and loaded again still fit.

#include <optional>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/line.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/near_map.hpp"

namespace wend {

inline constexpr double kPointTolerance = 1e-9;  // cells

class PointSweep {
 public:
  /// Starts at a point in grid coordinates. The space must outlive the sweep. No way is free from or to
  /// a point that is not is_exact(), nor along an arc that is not near_map().
  PointSweep(const FreeSpace& space, Point start, Adjacency adjacency = Adjacency::edges)
      : space_(&space), adjacency_(adjacency), at_(start), exact_(is_exact(start)) {}

  /// Moves along a line, or along an arc that begins at the current point. False if the way, including
  /// its first point, is not free; the sweep is then over. O(1) if the clearance of a cell shows that
  /// the way is free, else O(rows that it crosses).
  bool go_to(Point to);
  bool go_along(const Arc& arc);

 private:
  bool go_along_pieces(const Arc& arc);
  bool passes_its_gap(Point before, Point after) const;
  void arrive(Point to);

  const FreeSpace* space_;  // never null
  Adjacency adjacency_;
  Point at_;
  bool exact_;                       // does it start where numbers are?
  std::optional<Point> before_gap_;  // where the point came from, if it is in a gap
};

/// Is this point, up to rounding, a corner at which exactly two obstacles touch, diagonally?
bool in_gap(const FreeSpace& space, Point point);

}  // namespace wend
