#include "wend/path/smoothing/simplification.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/geometry/line.hpp"
#include "wend/path/length_fault.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/path/polyline.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/point_sweep.hpp"

namespace wend {
namespace {

/// A point nearer to a line than this lies on it: rounding.
constexpr double kOnLine = 1e-9;  // cells

/// Which shortcuts are free. None, once the deadline has passed.
class Sight {
 public:
  Sight(const FreeSpace& space, Adjacency adjacency, const Deadline& deadline)
      : space_(space), adjacency_(adjacency), stop_(&deadline) {}

  /// At every heading, so that the robot can turn anywhere. Points in gaps have no line of sight:
  /// whether a gap is free depends on where the path comes from.
  bool operator()(Point a, Point b) const {
    if (stop_.now()) return false;
    const bool gaps_matter = space_.radius_in_cells() == 0 && adjacency_ == Adjacency::edges;
    if (gaps_matter && (in_gap(space_, a) || in_gap(space_, b))) return false;
    return disc_fits_along(space_, Line{a, b}, adjacency_);
  }

  /// For a robot that comes to the line, and leaves it, with these headings, if it has any: a polygon
  /// also sees where it fits facing along the line and can turn at its ends.
  bool operator()(const Line& line, std::optional<double> arrival,
                  std::optional<double> departure) const {
    if ((*this)(line.from, line.to)) return true;
    if (!space_.outline() || line.length() == 0 || stop_.has_passed()) return false;
    const double heading = line.heading();
    return fits_along(space_, line) && turns(line.from, arrival, heading) &&
           turns(line.to, heading, departure);
  }

  bool has_shape() const { return space_.outline() != nullptr; }

  /// Has the deadline passed now?
  bool look() const { return stop_.now(); }
  /// Must who asks end? What it has made is of no use then.
  bool stopped() const { return stop_.has_passed(); }

 private:
  bool turns(Point at, std::optional<double> before, std::optional<double> after) const {
    return !before || !after || turns_with_margin(space_, at, *before, *after);
  }

  const FreeSpace& space_;
  Adjacency adjacency_;
  mutable DeadlineCheck stop_;
};

Unexpected<Error> stopped_while(const char* stage, const Deadline& deadline) {
  return failure(deadline.status(), deadline.text() + ", before the path was " + stage);
}

/// Does a line go straight on, from b to c, in the direction in which it left a for `second`? All
/// its points are held to one direction, so that many small bends are not lost one by one.
bool goes_straight_on(Point a, Point second, Point b, Point c) {
  const double length = distance(a, second);
  const Point along{(second.x - a.x) / length, (second.y - a.y) / length};
  const double off = along.x * (c.y - a.y) - along.y * (c.x - a.x);
  return std::abs(off) < kOnLine && along.x * (c.x - b.x) + along.y * (c.y - b.y) > 0;
}

/// The index of the inner point of first..last that is farthest from the line between the two.
std::size_t farthest_from_line(std::span<const Point> points, std::size_t first, std::size_t last) {
  std::size_t farthest = first + 1;
  double greatest = -1;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off = distance(Line{points[first], points[last]}, points[i]);
    if (off > greatest) {
      greatest = off;
      farthest = i;
    }
  }
  return farthest;
}

/// The last of `count` points from which on that of `from` is out of sight, by sees(index), found by
/// steps that double and then halve. At least the next one, to which the path itself leads.
template <class Sees>
std::size_t last_in_sight(std::size_t count, std::size_t from, const Sees& sees) {
  std::size_t seen = from + 1;
  std::size_t step = 1;
  while (seen + step < count && sees(seen + step)) {
    seen += step;
    step *= 2;
  }
  for (; step > 0; step /= 2) {
    if (seen + step < count && sees(seen + step)) seen += step;
  }
  return seen;
}

std::vector<std::size_t> pulled_forwards(std::span<const Point> points, const Sight& sight) {
  std::vector<std::size_t> kept{0};
  while (kept.back() + 1 < points.size()) {
    const std::size_t from = kept.back();
    kept.push_back(last_in_sight(points.size(), from,
                                 [&](std::size_t to) { return sight(points[from], points[to]); }));
  }
  return kept;
}

/// The heading of the path where it leaves a point; none at its end.
std::optional<double> departure_from(std::span<const Point> points, std::size_t at) {
  for (std::size_t next = at + 1; next < points.size(); ++next) {
    if (points[next] != points[at]) return Line{points[at], points[next]}.heading();
  }
  return std::nullopt;
}

/// A way that is being made, and the heading at its end.
struct Way {
  std::vector<Point> points;
  std::optional<double> heading{};  // none as long as it stands

  void go_to(Point point) {
    if (point != points.back()) heading = Line{points.back(), point}.heading();
    points.push_back(point);
  }
};

/// Once more, by the robot's own shape, forwards: headings tell where it can turn.
std::vector<Point> pulled_by_shape(std::span<const Point> points, const Sight& sight) {
  Way way{{points.front()}};
  for (std::size_t at = 0; at + 1 < points.size();) {
    at = last_in_sight(points.size(), at, [&](std::size_t to) {
      return sight(Line{points[at], points[to]}, way.heading, departure_from(points, to));
    });
    way.go_to(points[at]);
  }
  return way.points;
}

std::vector<std::size_t> pulled_backwards(std::vector<Point> points, const Sight& sight) {
  std::reverse(points.begin(), points.end());
  std::vector<std::size_t> kept = pulled_forwards(points, sight);
  for (std::size_t& index : kept) index = points.size() - 1 - index;
  std::reverse(kept.begin(), kept.end());
  return kept;
}

/// The shortest way through some of the candidates, from the first to the last, that joins those in
/// sight of each other and no more than a limit apart.
std::vector<Point> shortest_through(const std::vector<std::size_t>& candidates,
                                    std::span<const Point> points, const Sight& sight) {
  constexpr std::size_t kReach = 16;
  const std::size_t count = candidates.size();
  std::vector<double> lengths(count, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(count, 0);
  lengths[0] = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < std::min(count, i + 1 + kReach); ++j) {
      const Point a = points[candidates[i]];
      const Point b = points[candidates[j]];
      const double length = lengths[i] + distance(a, b);
      const bool on_path = candidates[j] == candidates[i] + 1;
      if (length >= lengths[j] || (!on_path && !sight(a, b))) continue;
      lengths[j] = length;
      from[j] = i;
    }
  }
  std::vector<Point> way{points[candidates.back()]};
  for (std::size_t i = count - 1; i > 0; i = from[i]) way.push_back(points[candidates[from[i]]]);
  std::reverse(way.begin(), way.end());
  return way;
}

/// In how many pieces, all as long, a length is cut so that they are nearest to `spacing`. No path has more than
/// kMostResampled.
int pieces_of(double length, double spacing) {
  constexpr auto kMost = static_cast<double>(kMostResampled);
  return static_cast<int>(std::clamp(std::round(length / spacing), 1.0, kMost));
}

/// Lines would not join poses.
std::optional<Error> fault_of_lines(const Path& path, std::optional<Error> fault) {
  if (fault || !path.driven()) return fault;
  return Error{Status::unsupported_query,
               "a path of poses cannot be simplified: its arcs need their end points",
               {}};
}

std::optional<Error> fault_of_spacing(double length, double spacing) {
  if (!(spacing > 0 && std::isfinite(spacing))) {
    return Error{
        Status::invalid_option,
        "spacing is " + format_number(spacing) + ": a finite number of cells above 0 expected",
        "spacing"};
  }
  const double points = length / spacing;
  if (points <= static_cast<double>(kMostResampled)) return std::nullopt;
  return Error{Status::invalid_option,
               "resampling would make " + format_number(std::floor(points)) + " points, and " +
                   std::to_string(kMostResampled) + " is the limit: choose a larger spacing",
               "spacing"};
}

Path resampled_drive(const JoinedPoses& drive, double spacing, DeadlineCheck& stop) {
  std::vector<Pose> divided{drive.poses().front()};
  for (std::size_t i = 0; i < drive.segment_count() && !stop.now(); ++i) {
    const Segment segment = drive.segment(i);
    const int pieces = pieces_of(std::abs(segment.length), spacing);
    for (int k = 1; k < pieces; ++k) {
      divided.push_back(pose_on(segment, static_cast<double>(k) / pieces));
    }
    divided.push_back(drive.poses()[i + 1]);
  }
  return Path::through(std::move(divided));
}

Path resampled_lines(const Polyline& line, double spacing, const Sight& sight) {
  const auto along = line.along();
  const int pieces = line.length() > 0 ? pieces_of(line.length(), spacing) : 0;
  Way way{{line.points().front()}};
  double last = 0;
  for (int i = 1; i <= pieces && !sight.stopped(); ++i) {
    const double next = line.length() * i / pieces;
    const Point point = i == pieces ? line.points().back() : line.at(next).point();
    const auto departure = i == pieces ? std::nullopt : std::optional(line.at(next).heading);
    if (!sight(Line{way.points.back(), point}, way.heading, departure)) {
      const auto begin = std::ranges::upper_bound(along, last);
      const auto end = std::ranges::lower_bound(along, next);
      for (auto own = begin; own < end; ++own) {
        way.go_to(line.points()[static_cast<std::size_t>(own - along.begin())]);
      }
    }
    way.go_to(point);
    last = next;
  }
  return Path::along(std::move(way.points));
}

}  // namespace

Expected<Path, Error> without_collinear(const Path& path) {
  if (auto fault = fault_of_lines(path, fault_of(path)))
    return Unexpected<Error>(*std::move(fault));
  const Polyline line(path.points());  // without points on top of each other
  const auto points = line.points();
  std::vector<Point> kept{points.front()};
  std::size_t begin = 0;  // of the straight line that the path is on
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool last = i + 1 == points.size();
    if (!last && goes_straight_on(points[begin], points[begin + 1], points[i], points[i + 1])) {
      continue;
    }
    kept.push_back(points[i]);
    begin = i;
  }
  return Path::along(std::move(kept));
}

Expected<Path, Error> simplified(const Path& path, double tolerance, const FreeSpace& space,
                                 Adjacency adjacency, const Deadline& deadline) {
  if (auto fault = fault_of_lines(path, fault_of(path, space))) {
    return Unexpected<Error>(*std::move(fault));
  }
  if (auto fault = fault_of_length("tolerance", tolerance)) {
    return Unexpected<Error>(*std::move(fault));
  }
  const Sight sight(space, adjacency, deadline);
  const std::vector<Point> points = path.points();
  Way way{{points.front()}};
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty() && !sight.stopped()) {
    const auto [first, last] = open.back();
    open.pop_back();
    if (last <= first + 1) {
      if (last > first) way.go_to(points[last]);
      continue;
    }
    const std::size_t farthest = farthest_from_line(points, first, last);
    const Line line{points[first], points[last]};
    if (sight.look()) break;
    if (distance(line, points[farthest]) <= tolerance &&
        sight(line, way.heading, departure_from(points, last))) {
      way.go_to(points[last]);
    } else {  // the nearer half comes off the stack first
      open.emplace_back(farthest, last);
      open.emplace_back(first, farthest);
    }
  }
  if (sight.stopped()) return stopped_while("simplified", deadline);
  return Path::along(std::move(way.points));
}

Expected<Path, Error> string_pulled(const Path& path, const FreeSpace& space, Adjacency adjacency,
                                    const Deadline& deadline) {
  if (auto fault = fault_of_lines(path, fault_of(path, space))) {
    return Unexpected<Error>(*std::move(fault));
  }
  const Sight sight(space, adjacency, deadline);
  const std::vector<Point> points = path.points();
  // Each way alone leaves corners behind itself; the shortest of both mixed has the fewest.
  const std::vector<std::size_t> forwards = pulled_forwards(points, sight);
  const std::vector<std::size_t> backwards = pulled_backwards(points, sight);
  std::vector<std::size_t> candidates;
  std::ranges::set_union(forwards, backwards, std::back_inserter(candidates));
  std::vector<Point> pulled = shortest_through(candidates, points, sight);
  if (sight.has_shape()) pulled = pulled_by_shape(pulled, sight);
  if (sight.stopped()) return stopped_while("simplified", deadline);
  return Path::along(std::move(pulled));
}

Expected<Path, Error> resampled(const Path& path, double spacing, const FreeSpace& space,
                                Adjacency adjacency, const Deadline& deadline) {
  if (auto fault = fault_of(path, space)) return Unexpected<Error>(*std::move(fault));
  if (auto fault = fault_of_spacing(path.length(), spacing)) {
    return Unexpected<Error>(*std::move(fault));
  }
  const Sight sight(space, adjacency, deadline);
  DeadlineCheck stop(&deadline);
  Path points =
      path.visit([&](const JoinedPoses& drive) { return resampled_drive(drive, spacing, stop); },
                 [&](const auto&) { return resampled_lines(polyline_of(path), spacing, sight); });
  if (sight.stopped() || stop.has_passed()) return stopped_while("resampled", deadline);
  return points;
}

}  // namespace wend
