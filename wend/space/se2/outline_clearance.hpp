#pragma once

// OutlineClearance: how far a convex polygon is from the obstacles of a map.
//
// Two sets with straight edges that do not overlap are nearest to each other at a corner of one of them. So the
// distance is the least of those of the polygon's corners from the obstacles, which the distances of cells tell, and
// of the obstacles' convex corners from the polygon. These are listed, tile by tile, when the clearance is made.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/geometry/polygon.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

class OutlineClearance {
 public:
  /// Of nothing.
  OutlineClearance() = default;

  /// Nothing for a polygon with a hollow, and for a map on which obstacles have more corners than a sixteenth of its
  /// cells. O(cells / 64 + corners).
  OutlineClearance(const FreeSpace& space, const Polygon& outline);

  bool empty() const { return tiles_.empty(); }

  /// The distance of the polygon at a pose from the obstacles, and from the map's edge if the outside is blocked, in
  /// cells: at most this, and at most `most`. Not above 0 where it overlaps one. The pose is at most half a cell away
  /// from one at which the polygon overlaps nothing, so that it does not lie across a wall. O(tiles + corners of
  /// obstacles around the polygon).
  double at(const FreeSpace& space, const Pose& pose, double most) const;

 private:
  static constexpr int kTile = 16;  // cells

  /// An edge of the polygon: how far a point is outside it is the product with its normal, less the offset.
  struct Edge {
    Point normal;
    double offset;
  };

  struct Corner {
    float x;
    float y;
  };

  /// How far a point that is less than some distance outside all edges may be from the base point.
  double reach(double outside) const { return farthest_ + mitre_ * outside; }
  double of_corner(const FreeSpace& space, Point corner, double most) const;
  double outside(double ahead, double aside, double most) const;
  std::size_t tile_of(int column, int row) const {
    return static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column);
  }

  std::vector<Point> outline_;
  std::vector<Edge> edges_;
  double farthest_ = 0;               // the distance of a corner of the polygon from the base point
  double mitre_ = 0;                  // how far one moves if all edges move out by 1
  std::size_t columns_ = 0;           // of tiles
  int rows_ = 0;                      // the same
  std::vector<std::uint32_t> tiles_;  // the first corner of each tile, and the end of the last one
  std::vector<Corner> corners_;       // of obstacles, tile by tile
};

}  // namespace wend
