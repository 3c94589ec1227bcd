#include "wend/control/nearest_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace wend {
namespace {

double squared_distance(Point a, Point b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// Of several places that are as near but for rounding the first counts.
constexpr double kSquaredRounding = 1e-18;

/// The nearest place of one of the lines, as far as it is in reach.
struct Place {
  std::size_t piece = 0;
  double along = 0;
  double squared = std::numeric_limits<double>::infinity();  // its distance
  double squared_end = 0;                                    // that of the piece's end
  Point point;
};

class Search {
 public:
  Search(const Polyline& line, const Pose& pose, const Reach& reach,
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
    const Point a = points_[piece];
    const Point b = points_[piece + 1];
    const double length = along_[piece + 1] - along_[piece];
    const double dot = (at_.x - a.x) * (b.x - a.x) + (at_.y - a.y) * (b.y - a.y);
    const double along = std::clamp(along_[piece] + dot / length, std::max(from_, along_[piece]),
                                    std::min(to_, along_[piece + 1]));
    const double share = (along - along_[piece]) / length;
    const Point point{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    return {piece, along, squared_distance(point, at_), squared_distance(b, at_), point};
  }

  /// In a corner one of its two lines is enough.
  bool leads(const Place& place) const {
    if (leads_on(place.piece)) return true;
    const bool in_corner = place.squared_end <= place.squared + kSquaredRounding;
    return in_corner && in_reach(place.piece + 1) && leads_on(place.piece + 1);
  }

  bool leads_on(std::size_t piece) const {
    const Point a = points_[piece];
    const Point b = points_[piece + 1];
    const double ahead =
        std::cos(pose_.heading) * (b.x - a.x) + std::sin(pose_.heading) * (b.y - a.y);
    const bool reverse = !gears_.empty() && gears_[piece] < 0;
    return reverse ? ahead <= 0 : ahead >= 0;
  }

  std::span<const Point> points_;
  std::span<const double> along_;
  Point at_;
  Pose pose_;
  double from_;
  double to_;
  std::size_t first_;
  std::span<const std::int8_t> gears_;
};

}  // namespace

OnPolyline nearest_ahead(const Polyline& line, const Pose& pose, const Reach& reach,
                         std::span<const std::int8_t> gears) {
  if (line.points().size() < 2) return line.nearest(pose.point(), 0, 0);
  const Search search(line, pose, reach, gears);
  const double nearest = search.nearest_squared();
  const double limit = std::sqrt(nearest) + reach.tie;
  const Place place = search.choose(std::max(limit * limit, nearest));  // a root rounds down, too
  return {place.along, place.point, std::sqrt(place.squared)};
}

}  // namespace wend
