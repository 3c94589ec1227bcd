#include "wend/control/nearest_ahead.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

template <class PointType>
double squared_distance(PointType a, PointType b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// Of several places that are as near but for rounding the first counts.
constexpr double kSquaredRounding = 1e-18;

/// The nearest place of one of the lines, as far as it is in reach.
template <class PointType>
struct PlaceAhead {
  std::size_t piece = 0;
  double along = 0;
  double squared = std::numeric_limits<double>::infinity();  // its distance
  double squared_end = 0;                                    // that of the piece's end
  PointType point;
};

template <class PoseType>
class Search {
 public:
  using PointType = typename BasicPolyline<PoseType>::PointType;
  using Place = PlaceAhead<PointType>;

  Search(const BasicPolyline<PoseType>& line, const PoseType& pose, const Reach& reach,
         std::span<const std::int8_t> gears)
      : points_(line.points()),
        along_(line.along()),
        at_(pose.point()),
        pose_(pose),
        from_(std::clamp(reach.from, 0.0, line.length())),
        to_(std::clamp(reach.to, from_, line.length())),
        first_(line.piece_at(from_)),
        gears_(gears) {}

  double nearest_squared() const {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = first_; in_reach(i); ++i) {
      nearest = std::min(nearest, place_on(i).squared);
    }
    return nearest;
  }

  /// The nearest place of the first visit that leads the robot's way, else of the first visit.
  Place choose(double squared_limit) const {
    std::optional<Place> first_visit;
    std::optional<Place> visit;
    for (std::size_t i = first_; in_reach(i); ++i) {
      const Place place = place_on(i);
      if (place.squared <= squared_limit &&
          (!visit || place.squared + kSquaredRounding < visit->squared)) {
        visit = place;
      }
      const bool goes_on = place.squared_end <= squared_limit && in_reach(i + 1);
      if (!visit || goes_on) continue;
      if (leads(*visit)) return *visit;
      if (!first_visit) first_visit = visit;
      visit.reset();
    }
    return first_visit ? *first_visit : place_on(first_);
  }

 private:
  bool in_reach(std::size_t piece) const {
    return piece + 1 < points_.size() && (piece == first_ || along_[piece] <= to_);
  }

  Place place_on(std::size_t piece) const {
    const PointType a = points_[piece];
    const PointType b = points_[piece + 1];
    const double length = along_[piece + 1] - along_[piece];
    const double dot = (at_.x - a.x) * (b.x - a.x) + (at_.y - a.y) * (b.y - a.y);
    const double along = std::clamp(along_[piece] + dot / length, std::max(from_, along_[piece]),
                                    std::min(to_, along_[piece + 1]));
    const double share = (along - along_[piece]) / length;
    const PointType point{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    return {piece, along, squared_distance(point, at_), squared_distance(b, at_), point};
  }

  /// In a corner one of its two lines is enough.
  bool leads(const Place& place) const {
    if (leads_on(place.piece)) return true;
    const bool in_corner = place.squared_end <= place.squared + kSquaredRounding;
    return in_corner && in_reach(place.piece + 1) && leads_on(place.piece + 1);
  }

  bool leads_on(std::size_t piece) const {
    const PointType a = points_[piece];
    const PointType b = points_[piece + 1];
    const auto [sine, cosine] = sine_and_cosine(pose_.heading);
    const double ahead = cosine * (b.x - a.x) + sine * (b.y - a.y);
    const bool reverse = !gears_.empty() && gears_[piece] < 0;
    return reverse ? ahead <= 0 : ahead >= 0;
  }

  std::span<const PointType> points_;
  std::span<const double> along_;
  PointType at_;
  PoseType pose_;
  double from_;
  double to_;
  std::size_t first_;
  std::span<const std::int8_t> gears_;
};

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
    const Polyline chords = polyline_of(std::span(&arc, 1));
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
  const auto from_here = [&](const auto& joints, const auto& joint) {
    std::vector<std::remove_cvref_t<decltype(joint)>> rest(joints.begin() + next, joints.end());
    if (!at_next) rest.insert(rest.begin(), joint);
    return rest;
  };
  return path.visit(
      [&](const JoinedPoses& joined) { return Path::through(from_here(joined.poses(), here)); },
      [&](const auto&) { return Path::along(from_here(path.points(), here.point())); });
}

template <class PoseType>
auto find_nearest_ahead(const BasicPolyline<PoseType>& line, const PoseType& pose,
                        const Reach& reach, std::span<const std::int8_t> gears)
    -> BasicOnPolyline<typename BasicPolyline<PoseType>::PointType> {
  if (line.points().size() < 2) return line.nearest(pose.point(), 0, 0);
  const Search<PoseType> search(line, pose, reach, gears);
  const double nearest = search.nearest_squared();
  const double limit = std::sqrt(nearest) + reach.tie;
  const auto place = search.choose(std::max(limit * limit, nearest));  // a root rounds down, too
  return {place.along, place.point, std::sqrt(place.squared)};
}

}  // namespace

OnPolyline nearest_ahead(const Polyline& line, const Pose& pose, const Reach& reach,
                         std::span<const std::int8_t> gears) {
  return find_nearest_ahead(line, pose, reach, gears);
}

OnMapPolyline nearest_ahead(const MapPolyline& line, const MapPose& pose, const Reach& reach,
                            std::span<const std::int8_t> gears) {
  return find_nearest_ahead(line, pose, reach, gears);
}

Remaining remaining(const Path& path, const Pose& pose, double from) {
  assert(!path.empty() && from >= 0);
  const std::vector<Arc> arcs = path.arcs();
  if (arcs.empty()) {
    Path rest = path.visit([&](const JoinedPoses&) { return path; },
                           [&](const auto&) { return Path::along(path.points()); });
    return {std::move(rest), 0, distance(path.points().front(), pose.point())};
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
