#pragma once

// Polyline: straight lines through points, parametrised by length: resampling, controllers and
// remaining() use it. For a car's path it has points on the arcs, as few as the tolerance allows.
//
//   const wend::Polyline line({{0, 0}, {3, 0}, {3, 4}});
//   const wend::Pose middle = line.at(5);                                    // (3,2), heading up y
//   const wend::OnPolyline nearest = line.nearest({2, 1}, 0, line.length());  // (2,0), 2 along
//
// A Polyline is in grid coordinates, a MapPolyline in metres. A closed polyline continues from its last
// point to its first; equal successive points count once. Immutable.

#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// A place on a polyline, in the polyline's coordinates.
template <class PointType>
struct BasicOnPolyline {
  double along = 0;     // the length from the first point to it
  PointType point;      // where it is
  double distance = 0;  // from the point of the query
};

/// A place in grid coordinates.
using OnPolyline = BasicOnPolyline<Point>;
/// A place in metres.
using OnMapPolyline = BasicOnPolyline<MapPoint>;

/// Straight lines through points; PoseType is Pose or MapPose.
template <class PoseType>
class BasicPolyline {
 public:
  /// Its points: Point or MapPoint.
  using PointType = decltype(PoseType().point());

  /// Needs at least one point, all finite. `closed`: a line joins the last to the first.
  explicit BasicPolyline(std::span<const PointType> points, bool closed = false);
  /// The same for a list of points.
  BasicPolyline(std::initializer_list<PointType> points, bool closed = false)
      : BasicPolyline(std::span(points.begin(), points.size()), closed) {}

  /// Its points, no two successive ones equal; a closed polyline repeats the first at the end.
  std::span<const PointType> points() const { return points_; }

  /// The length up to each point; the first is 0, the last length().
  std::span<const double> along() const { return along_; }

  /// The length of all lines.
  double length() const { return along_.back(); }
  /// Does a line join the last point to the first?
  bool closed() const { return closed_; }

  /// The place at length `along`, clamped to 0..length(), and the heading of the line there (at a
  /// joint, of the line that begins; a single point heads along +x). O(log n).
  PoseType at(double along) const;

  /// The mean heading from `window` (>= 0) before that place to as far behind it: of a curve given by
  /// points its heading but for little, where that of its lines jumps from point to point. The window
  /// is no longer than what is left to either end; a closed line has none. Where the line comes back
  /// to where it was, the heading of at(). O(log n).
  double heading_at(double along, double window) const;

  /// The line on which that place lies: the index of its first point. O(log n).
  std::size_t piece_at(double along) const;

  /// The place between `from` and `to` along (clamped, from <= to) that is nearest to a point; of
  /// several the first. O(lines between).
  BasicOnPolyline<PointType> nearest(PointType point, double from, double to) const;

 private:
  std::vector<PointType> points_;
  std::vector<double> along_;
  bool closed_;
};

/// A polyline in grid coordinates.
using Polyline = BasicPolyline<Pose>;
/// A polyline in metres.
using MapPolyline = BasicPolyline<MapPose>;

extern template class WEND_API BasicPolyline<Pose>;
extern template class WEND_API BasicPolyline<MapPose>;

/// The polyline of a path (not empty, without a fault); arcs within `tolerance` cells, if kMostPosesAlong chords do.
WEND_API Polyline polyline_of(const Path& path, bool closed = false, double tolerance = 0.01);

/// The same of arcs (at least one), each beginning where the one before it ends.
WEND_API Polyline polyline_of(std::span<const Arc> arcs, double tolerance = 0.01);

/// No more poses than these are made along a line, nor chords along arcs (but at least one an arc).
inline constexpr std::size_t kMostPosesAlong = 1'000'000;

/// Poses on a polyline, `spacing` (> 0) apart along it, from its beginning on; the last is its end. Only the
/// beginning and the end for a spacing that is NaN, not above 0, or makes more than kMostPosesAlong poses.
WEND_API std::vector<Pose> poses_along(const Polyline& line, double spacing);
/// The same in metres.
WEND_API std::vector<MapPose> poses_along(const MapPolyline& line, double spacing);

/// The same along a path of poses (not empty), with their headings.
WEND_API std::vector<Pose> poses_along(const JoinedPoses& drive, double spacing);

}  // namespace wend
