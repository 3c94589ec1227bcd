#include "wend/path/path_collision.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <vector>

#include "wend/base/choice.hpp"
#include "wend/geometry/arc_distance.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"
#include "wend/robot/sweep/point_sweep.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

constexpr double kBisected = 5e-7;  // cells

Line beginning_of(const Line& line, double share) { return {line.from, line.at(share)}; }
Arc beginning_of(const Arc& arc, double share) {
  return {arc.from, arc.length * share, arc.curvature};
}

TurnInPlace beginning_of(const TurnInPlace& turn, double share) {
  return {turn.from, turn.angle * share};
}

using wend::beginning_of;

Pose end_of(const Line& line) { return {line.to.x, line.to.y, line.heading()}; }
using wend::end_of;

/// Does the robot's base point stay on the map?
template <class Way>
bool on_map(const FreeSpace& space, const Way& way) {
  return distance_inside(space, way) >= -kPointTolerance;
}

/// The obstacle nearest to a point, of several the one whose centre is.
std::optional<Cell> nearest_obstacle(const FreeSpace& space, Point point, double within) {
  std::optional<Cell> nearest;
  double least = within;
  any_obstacle(space, Box(point).grown_by(within), [&](Cell square) {
    const double gap = distance(point, square);
    const bool nearer =
        gap < least || (gap == least && nearest &&
                        distance(point, centre_of(square)) < distance(point, centre_of(*nearest)));
    if (nearer || (gap <= within && !nearest)) {
      least = gap;
      nearest = square;
    }
    return false;
  });
  return nearest;
}

/// The obstacle that the robot's polygon overlaps, or is nearest to.
std::optional<Cell> nearest_to_polygon(const FreeSpace& space, const Pose& pose, double within) {
  const PlacedPolygon robot(*space.outline(), pose);
  std::optional<Cell> nearest;
  double least = within;
  any_obstacle(space, robot.box().grown_by(within), [&](Cell square) {
    const bool overlaps = robot.overlaps(square);
    const double gap = overlaps ? -1 : robot.distance_to(square);
    if (gap > least || (nearest && gap == least)) return false;
    least = gap;
    nearest = square;
    return overlaps;
  });
  return nearest;
}

/// The greatest share of a way at whose beginning a test holds, and one at which it does not any more. It holds at
/// `low`, not at `high`, and at no share after one where it does not.
struct Limit {
  double low = 0;
  double high = 1;

  template <class Test>
  void bisect(double extent, const Test& holds) {
    while ((high - low) * extent > kBisected) {
      const double middle = (low + high) / 2;
      if (!(low < middle && middle < high)) return;
      (holds(middle) ? low : high) = middle;
    }
  }
};

/// Moves the space's robot along the pieces of a path until it collides; or without an adjacency its base point
/// until that leaves the map.
class PathSweep {
 public:
  PathSweep(const FreeSpace& space, Point start, std::optional<Adjacency> adjacency)
      : space_(space),
        adjacency_(adjacency),
        point_(space, start, adjacency.value_or(Adjacency::edges)) {}

  /// A line or an arc.
  template <class Way>
  std::optional<PathCollision> go_along(const Way& way) {
    if (auto collision = collision_along(way)) return collision;
    along_ += length_of(way);
    ++piece_;
    return std::nullopt;
  }

  /// Along a line; a polygon faces along it and turns to it in place, the shorter way.
  std::optional<PathCollision> turn_and_go_along(const Line& line) {
    if (!space_.outline()) return go_along(line);
    if (line.length() == 0) {  // it stands where the lines before and after it are looked at
      ++piece_;
      return std::nullopt;
    }
    const double heading = line.heading();
    if (heading_) {
      const TurnInPlace turn = turn_between(space_, line.from, *heading_, heading);
      if (auto collision = collision_along(turn)) return collision;
    }
    heading_ = heading;
    return go_along(line);
  }

  /// The next point is of no use: the path leaves the map where it is.
  PathCollision leave_at(Point point) const {
    return {CollisionKind::outside, piece_, along_, point, {}};
  }

 private:
  /// On the map alone the robot is swept: as far as its base point stays there.
  template <class Way>
  std::optional<PathCollision> collision_along(const Way& way) {
    if (!on_map(space_, way)) return collision_on_the_way_out(way);
    PointSweep point = point_;
    if (!fits(point, way)) return first_contact(way, 1);
    point_ = point;
    return std::nullopt;
  }

  template <class Way>
  PathCollision collision_on_the_way_out(const Way& way) const {
    const auto stays = [&](double share) { return on_map(space_, beginning_of(way, share)); };
    if (!stays(0)) return leave_at(end_of(beginning_of(way, 0)).point());
    Limit limit;
    limit.bisect(extent_of(way), stays);
    if (!fits_from_here(beginning_of(way, limit.low))) return first_contact(way, limit.low);
    return collision_at(way, limit);
  }

  template <class Way>
  bool fits(PointSweep& point, const Way& way) const {
    if (!adjacency_) return true;
    return space_.is_point() ? go(point, way) : fits_along(space_, way);
  }

  static bool go(PointSweep& point, const Line& line) { return point.go_to(line.to); }
  static bool go(PointSweep& point, const Arc& arc) { return point.go_along(arc); }
  static bool go(PointSweep& point, const Segment& segment) {
    return point.go_along(way_of_base(segment));
  }
  static bool go(PointSweep& point, const TurnInPlace& turn) {
    return point.go_to(turn.from.point());
  }

  template <class Way>
  bool fits_from_here(const Way& way) const {
    PointSweep point = point_;
    return fits(point, way);
  }

  /// How far no point of the robot goes more than.
  double extent_of(const TurnInPlace& turn) const {
    return space_.radius_in_cells() * std::abs(turn.angle);
  }
  double extent_of(const Segment& segment) const {
    return length_of(segment) + space_.radius_in_cells() * std::abs(segment.turn);
  }
  template <class Way>
  double extent_of(const Way& way) const {
    return length_of(way);
  }

  /// Bisects a piece whose beginning is not free.
  template <class Way>
  PathCollision first_contact(const Way& way, double share) const {
    const auto free = [&](double of_way) { return fits_from_here(beginning_of(way, of_way)); };
    Limit limit{0, share};
    if (!free(0)) return collision_at(way, {0, 0});
    limit.bisect(extent_of(way), free);
    return collision_at(way, limit);
  }

  template <class Way>
  PathCollision collision_at(const Way& way, const Limit& limit) const {
    PathCollision collision;
    collision.piece = piece_;
    collision.along = along_ + limit.low * length_of(way);
    collision.point = end_of(beginning_of(way, limit.low)).point();
    collision.kind = CollisionKind::outside;
    if (adjacency_) tell(beginning_of(way, limit.high), collision);
    return collision;
  }

  /// What the robot collides with at the end of a way that is just too long.
  template <class Way>
  void tell(const Way& way, PathCollision& collision) const {
    const Point end = end_of(way).point();
    constexpr double kReach = 4 * kBisected;
    const auto obstacle =
        space_.outline() ? nearest_to_polygon(space_, end_of(way), 2 * SweepOptions{}.tolerance)
                         : nearest_obstacle(space_, end, space_.radius_in_cells() + kReach);
    if (leaves_map(way, obstacle)) {
      collision.kind = CollisionKind::outside;
      return;
    }
    collision.obstacle = obstacle;
    const bool entered = obstacle && distance(end, *obstacle) == 0;
    if (space_.outline()) {
      collision.kind = entered ? CollisionKind::obstacle : CollisionKind::overlaps;
    } else if (!space_.is_point()) {
      collision.kind = entered ? CollisionKind::obstacle : CollisionKind::too_close;
    } else if (adjacency_ == Adjacency::edges &&
               fits_along(space_, way, {.adjacency = Adjacency::edges_and_corners})) {
      collision.kind = CollisionKind::squeezed;
    } else {
      collision.kind = CollisionKind::obstacle;
    }
  }

  /// Is it the map's edge that ends the way, and not the obstacle nearest to its end?
  template <class Way>
  bool leaves_map(const Way& way, const std::optional<Cell>& obstacle) const {
    if (space_.outline()) return !on_map(space_, way) || !obstacle;
    if (space_.is_point() || space_.outside() == OutsidePolicy::free) {
      return !on_map(space_, way) && fits_from_here(way);
    }
    if (keeps_distance(space_, edge_clearance(space_, way))) return false;
    return !obstacle || keeps_distance(space_, distance(end_of(way).point(), *obstacle));
  }

  const FreeSpace& space_;
  std::optional<Adjacency> adjacency_;
  PointSweep point_;
  std::optional<double> heading_;  // of a polygon, once it has moved
  std::size_t piece_ = 0;
  double along_ = 0;
};

/// Along arcs, turns in place, and segments on which the robot does not face along its way.
std::optional<PathCollision> collision_of_drive(const JoinedPoses& drive, PathSweep& sweep) {
  if (drive.segment_count() == 0) return sweep.go_along(TurnInPlace{drive.poses().front(), 0});
  for (std::size_t i = 0; i < drive.segment_count(); ++i) {
    const Segment segment = drive.segment(i);
    std::optional<PathCollision> collision;
    if (segment.length == 0) {
      collision = sweep.go_along(TurnInPlace{segment.from, segment.turn});
    } else {
      collision = segment.course == 0 ? sweep.go_along(drive.arc(i)) : sweep.go_along(segment);
    }
    if (collision) return collision;
  }
  return std::nullopt;
}

/// Along lines from point to point.
std::optional<PathCollision> collision_of_lines(std::span<const Point> points, PathSweep& sweep) {
  const auto stands = [&](Point point) { return point == points.front(); };
  if (std::all_of(points.begin(), points.end(), stands)) {
    return sweep.go_along(Line{points.front(), points.front()});
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (const auto collision = sweep.turn_and_go_along({points[i - 1], points[i]}))
      return collision;
  }
  return std::nullopt;
}

/// The point of the map nearest to one that may contain NaN or infinity; the origin for NaN.
Point nearest_on_map(const FreeSpace& space, Point point) {
  return {std::min(std::max(0.0, point.x), space.width() + 0.0),
          std::min(std::max(0.0, point.y), space.height() + 0.0)};
}

/// Sweeps the part of a path that has no fault, and leaves the map where that ends.
std::optional<PathCollision> collision_of(const Path& path, const FreeSpace& space,
                                          std::optional<Adjacency> adjacency) {
  if (path.empty()) return std::nullopt;
  std::vector<Point> points = path.points();
  const std::size_t good = points_without_fault(path);
  const bool whole = good == points.size();
  points.resize(good);
  if (points.empty()) {
    const Point start = nearest_on_map(space, path.points().front());
    return PathSweep(space, start, adjacency).leave_at(start);
  }
  PathSweep sweep(space, points.front(), adjacency);
  auto collision = path.visit(
      [&](const JoinedPoses& drive) {
        return collision_of_drive(JoinedPoses(drive.poses().first(good)), sweep);
      },
      [&](const auto&) { return collision_of_lines(points, sweep); });
  if (!collision && !whole) return sweep.leave_at(points.back());
  return collision;
}

}  // namespace

std::string_view describe(CollisionKind kind) {
  constexpr std::array<Choice<CollisionKind>, 5> kTexts{
      {{"leaves the map", CollisionKind::outside},
       {"enters an obstacle", CollisionKind::obstacle},
       {"comes closer to an obstacle than the robot's radius", CollisionKind::too_close},
       {"overlaps an obstacle with its footprint", CollisionKind::overlaps},
       {"passes between two obstacles that touch at a corner", CollisionKind::squeezed}}};
  return choice_name(kind, kTexts);
}

std::optional<PathCollision> first_collision(const Path& path, const FreeSpace& space,
                                             Adjacency adjacency) {
  return collision_of(path, space, adjacency);
}

std::optional<PathCollision> first_exit(const Path& path, const FreeSpace& space) {
  return collision_of(path, space, std::nullopt);
}

}  // namespace wend
