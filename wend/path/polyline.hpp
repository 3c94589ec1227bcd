#pragma once

// Polyline: straight lines through points, measured along: what resampling, controllers and
// remaining() walk on. Of a car's path, points of its arcs no farther apart than they must be.
//
//   const wend::Polyline line({{0, 0}, {3, 0}, {3, 4}});
//   const wend::Pose middle = line.at(5);                                    // (3,2), heading up y
//   const wend::OnPolyline nearest = line.nearest({2, 1}, 0, line.length());  // (2,0), 2 along
//
// Unit-free: in whatever coordinates its points are. A closed one goes on from its last point to
// its first; points on top of each other count once. Immutable.

#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// A place on a polyline.
struct OnPolyline {
  double along = 0;  // the length from the first point to it
  Point point;
  double distance = 0;  // from what was asked for
};

class Polyline {
 public:
  /// At least one point, all finite. `closed`: the last is joined to the first.
  explicit Polyline(std::span<const Point> points, bool closed = false);
  Polyline(std::initializer_list<Point> points, bool closed = false)
      : Polyline(std::span(points.begin(), points.size()), closed) {}

  /// Of a path (not empty), in grid coordinates; arcs within `tolerance` cells.
  static Polyline of(const Path& path, bool closed = false, double tolerance = 0.01);

  /// Its points, no two successive ones equal; of a closed one the first comes again at the end.
  std::span<const Point> points() const { return points_; }

  /// How far along each point lies; the first is 0, the last length().
  std::span<const double> along() const { return along_; }

  double length() const { return along_.back(); }
  bool closed() const { return closed_; }

  /// The place so far along, clamped to 0..length(), and the heading of the line there (where two
  /// meet: of the one that begins; a single point heads along +x). O(log n).
  Pose at(double along) const;

  /// The mean heading from `window` (>= 0) before that place to as far behind it: of a curve given by
  /// points its heading but for little, where that of its lines jumps from point to point. The window
  /// is no longer than what is left to either end; a closed line has none. Where the line comes back
  /// to where it was, the heading of at(). O(log n).
  double heading_at(double along, double window) const;

  /// The line on which that place lies: the index of its first point. O(log n).
  std::size_t piece_at(double along) const;

  /// The place between `from` and `to` along (clamped, from <= to) that is nearest to a point; of
  /// several the first. O(lines between).
  OnPolyline nearest(Point point, double from, double to) const;

 private:
  std::vector<Point> points_;
  std::vector<double> along_;
  bool closed_;
};

}  // namespace wend
