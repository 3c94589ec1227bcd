#include "wend/path/polyline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "wend/geometry/line.hpp"
#include "wend/path/chord_counts.hpp"

namespace wend {
namespace {

/// The ends of the chords of arcs.
std::vector<Point> chords_of(Point start, std::span<const Arc> arcs, double tolerance) {
  std::vector<Point> points{start};
  const std::vector<int> counts = chord_counts(arcs, tolerance);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const auto& arc = arcs[i];
    for (int k = 1; k <= counts[i]; ++k) {
      points.push_back(point_on(arc, arc.length * k / counts[i]));
    }
  }
  return points;
}

/// The number of gaps that are `spacing` wide, the last one perhaps less; 1 if they cannot be made.
std::size_t gaps_of(double length, double spacing) {
  const double gaps = std::ceil(length / spacing);
  const bool fine = spacing > 0 && gaps < static_cast<double>(kMostPosesAlong);
  return fine ? static_cast<std::size_t>(gaps) : 1;
}

template <class PoseType>
std::vector<PoseType> poses_every(const BasicPolyline<PoseType>& line, double spacing) {
  const std::size_t gaps = gaps_of(line.length(), spacing);
  std::vector<PoseType> poses;
  poses.reserve(gaps + 1);
  if (gaps > 0) poses.push_back(line.at(0));
  for (std::size_t i = 1; i < gaps; ++i) poses.push_back(line.at(static_cast<double>(i) * spacing));
  poses.push_back(line.at(line.length()));
  return poses;
}

}  // namespace

template <class PoseType>
BasicPolyline<PoseType>::BasicPolyline(std::span<const PointType> points, bool closed)
    : closed_(closed) {
  assert(!points.empty());
  points_.reserve(points.size() + 1);
  along_.reserve(points.size() + 1);
  const auto append = [&](PointType point) {
    const double step = points_.empty() ? 0 : distance(points_.back(), point);
    if (!points_.empty() && step == 0) return;
    along_.push_back(points_.empty() ? 0 : along_.back() + step);
    points_.push_back(point);
  };
  for (const PointType point : points) append(point);
  if (closed) append(points.front());
}

template <class PoseType>
std::size_t BasicPolyline<PoseType>::piece_at(double along) const {
  if (points_.size() < 2) return 0;
  const auto next = std::upper_bound(along_.begin(), along_.end(), along);
  const auto index = std::distance(along_.begin(), next);
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(index - 1, 0, static_cast<std::ptrdiff_t>(points_.size()) - 2));
}

template <class PoseType>
PoseType BasicPolyline<PoseType>::at(double along) const {
  if (points_.size() < 2) return {points_.front().x, points_.front().y, 0};
  const std::size_t i = piece_at(along);
  const BasicLine<PointType> piece{points_[i], points_[i + 1]};
  const double share = std::clamp((along - along_[i]) / (along_[i + 1] - along_[i]), 0.0, 1.0);
  const PointType point = piece.at(share);
  return {point.x, point.y, piece.heading()};
}

template <class PoseType>
double BasicPolyline<PoseType>::heading_at(double along, double window) const {
  const double place = std::clamp(along, 0.0, length());
  const double half =
      closed_ ? std::min(window, length() / 4) : std::min({window, place, length() - place});
  const auto around = [this](double at_along) {
    return closed_ ? std::fmod(at_along + length(), length()) : at_along;
  };
  const PointType from = at(around(place - half)).point();
  const PointType to = at(around(place + half)).point();
  constexpr double kRounding = 1e-9;  // of the window: there the direction is noise
  if (distance(from, to) <= kRounding * half) return at(place).heading;
  return BasicLine<PointType>{from, to}.heading();
}

template <class PoseType>
auto BasicPolyline<PoseType>::nearest(PointType point, double from, double to) const
    -> BasicOnPolyline<PointType> {
  const double first = std::clamp(from, 0.0, length());
  const double last = std::clamp(to, first, length());
  const PointType start = at(first).point();
  BasicOnPolyline<PointType> best{first, start, distance(start, point)};
  if (points_.size() < 2) return best;
  for (std::size_t i = piece_at(first); i + 1 < points_.size() && along_[i] <= last; ++i) {
    const PointType a = points_[i];
    const PointType b = points_[i + 1];
    const double length = along_[i + 1] - along_[i];
    const double dot = (point.x - a.x) * (b.x - a.x) + (point.y - a.y) * (b.y - a.y);
    const double along = std::clamp(along_[i] + dot / length, std::max(first, along_[i]),
                                    std::min(last, along_[i + 1]));
    const PointType place = BasicLine<PointType>{a, b}.at((along - along_[i]) / length);
    const double gap = distance(place, point);
    if (gap < best.distance) best = {along, place, gap};
  }
  return best;
}

template class BasicPolyline<Pose>;
template class BasicPolyline<MapPose>;

Polyline polyline_of(const Path& path, bool closed, double tolerance) {
  const auto along_points = [&](const auto&) { return Polyline(path.points(), closed); };
  const auto along_arcs = [&](const JoinedPoses& joined) {
    return Polyline(chords_of(joined.poses().front().point(), path.arcs(), tolerance), closed);
  };
  return path.visit(along_points, along_arcs);
}

Polyline polyline_of(std::span<const Arc> arcs, double tolerance) {
  assert(!arcs.empty());
  return Polyline(chords_of(arcs.front().from.point(), arcs, tolerance));
}

std::vector<Pose> poses_along(const Polyline& line, double spacing) {
  return poses_every(line, spacing);
}
std::vector<MapPose> poses_along(const MapPolyline& line, double spacing) {
  return poses_every(line, spacing);
}

std::vector<Pose> poses_along(const JoinedPoses& drive, double spacing) {
  assert(!drive.poses().empty());
  std::vector<Pose> poses;
  if (drive.segment_count() > 0) poses.push_back(drive.poses().front());
  double whole = 0;
  for (std::size_t i = 0; i < drive.segment_count(); ++i) {
    whole += std::abs(drive.segment(i).length);
  }
  // From the start of the segment.
  double next = gaps_of(whole, spacing) > 1 ? spacing : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < drive.segment_count(); ++i) {
    const Segment segment = drive.segment(i);
    const double length = std::abs(segment.length);
    while (next < length) {
      poses.push_back(pose_on(segment, next / length));
      next += spacing;
    }
    next -= length;
  }
  poses.push_back(drive.poses().back());
  return poses;
}

}  // namespace wend
