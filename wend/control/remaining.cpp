#include "wend/control/remaining.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "wend/control/nearest_ahead.hpp"
#include "wend/path/polyline.hpp"

namespace wend {
namespace {

/// A path as a line of chords.
struct Walk {
  std::vector<Point> points;
  std::vector<std::int8_t> gears;  // of each line
  // Of each arc, and at the end: how far along the chords and along the path it begins.
  std::vector<double> along_chords{0};
  std::vector<double> along_path{0};
};

Walk walk_along(const Path& path, const std::vector<Arc>& arcs) {
  Walk walk;
  walk.points.push_back(path.points().front());
  for (const Arc& arc : arcs) {
    const Polyline chords =
        Polyline::of(path.driven() ? Path::through({arc.from, end_of(arc)})
                                   : Path::along({arc.from.point(), point_on(arc, arc.length)}));
    for (const Point point : chords.points()) {
      if (point == walk.points.back()) continue;
      walk.points.push_back(point);
      walk.gears.push_back(arc.length < 0 ? std::int8_t{-1} : std::int8_t{1});
    }
    walk.along_chords.push_back(walk.along_chords.back() + chords.length());
    walk.along_path.push_back(walk.along_path.back() + std::abs(arc.length));
  }
  return walk;
}

/// The arc on which a place lies, the later one where two meet; `bounds` are theirs.
std::size_t arc_at(const std::vector<double>& bounds, double along) {
  const auto next = std::upper_bound(bounds.begin() + 1, bounds.end() - 1, along);
  return static_cast<std::size_t>(next - bounds.begin()) - 1;
}

/// What is so far along by one measure, by another one.
double converted(double along, const std::vector<double>& from, const std::vector<double>& to) {
  const std::size_t i = arc_at(from, along);
  const double length = from[i + 1] - from[i];
  const double share = length > 0 ? std::clamp((along - from[i]) / length, 0.0, 1.0) : 0;
  return to[i] + share * (to[i + 1] - to[i]);
}

/// The rest of a path from so far along it.
Path rest_of(const Path& path, const std::vector<Arc>& arcs, const Walk& walk, double along) {
  const std::size_t i = arc_at(walk.along_path, along);
  const double driven = std::min(along - walk.along_path[i], std::abs(arcs[i].length));
  const Pose here = pose_on(arcs[i], std::copysign(driven, arcs[i].length));
  const bool at_next = driven == std::abs(arcs[i].length);
  const auto next = static_cast<std::ptrdiff_t>(i) + 1;
  if (path.driven()) {
    std::vector<Pose> poses(path.driven_poses().begin() + next, path.driven_poses().end());
    if (!at_next) poses.insert(poses.begin(), here);
    return Path::through(std::move(poses));
  }
  const std::vector<Point> all = path.points();
  std::vector<Point> points(all.begin() + next, all.end());
  if (!at_next) points.insert(points.begin(), here.point());
  return Path::along(std::move(points));
}

}  // namespace

Remaining remaining(const Path& path, const Pose& pose, double from) {
  assert(!path.empty() && from >= 0);
  const std::vector<Arc> arcs = path.arcs();
  if (arcs.empty()) {
    return {path.driven() ? path : Path::along(path.points()), 0,
            distance(path.points().front(), pose.point())};
  }
  const Walk walk = walk_along(path, arcs);
  const Polyline line(walk.points);
  constexpr double kTie = 1;
  const Reach reach{converted(from, walk.along_path, walk.along_chords), line.length(), kTie};
  const OnPolyline place = nearest_ahead(line, pose, reach, walk.gears);
  const double along = std::max(std::min(from, walk.along_path.back()),
                                converted(place.along, walk.along_chords, walk.along_path));
  Path rest = rest_of(path, arcs, walk, along);
  const double gap = distance(rest.points().front(), pose.point());
  return {std::move(rest), along, gap};
}

}  // namespace wend
