#include "wend/planner/rest_of_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

constexpr double kRounding = 1e-9;

/// Calls visit(0), visit(1), visit(2), visit(4), ... up to `last`, and visit(last).
template <class Visit>
void for_each_doubling(std::size_t last, Visit&& visit) {
  for (std::size_t i = 0; i < last; i = i == 0 ? 1 : 2 * i) visit(i);
  visit(last);
}

/// Takes what costs less; of equal costs, what joins the path earlier.
void take_cheaper(std::optional<Plan>& best, Path path, const Expected<double, PathFault>& cost) {
  if (!cost || (best && *cost >= best->cost - kRounding * best->cost)) return;
  best.emplace();
  best->path = std::move(path);
  best->cost = *cost;
}

std::int64_t squared_distance(Cell a, Cell b) {
  const std::int64_t dx = a.x - b.x;
  const std::int64_t dy = a.y - b.y;
  return dx * dx + dy * dy;
}

/// The cells of a line of steps between two cells, without the last.
std::vector<Cell> steps_towards(Cell from, Cell to, Connectivity connectivity) {
  const std::int64_t dx = to.x - from.x;
  const std::int64_t dy = to.y - from.y;
  const bool four = connectivity == Connectivity::four;
  const std::int64_t count =
      four ? std::abs(dx) + std::abs(dy) : std::max(std::abs(dx), std::abs(dy));
  const auto part = [count](std::int64_t of, std::int64_t i) {
    return static_cast<int>((2 * i * std::abs(of) + count) / (2 * count)) * (of < 0 ? -1 : 1);
  };
  std::vector<Cell> cells;
  for (std::int64_t i = 0; i < count; ++i) {
    const int x = part(dx, i);
    const int y = four ? (dy < 0 ? -1 : 1) * static_cast<int>(i - std::abs(x)) : part(dy, i);
    cells.push_back({from.x + x, from.y + y});
  }
  return cells;
}

/// The place on a line that is nearest to a point.
Point nearest_on_line(Point from, Point to, Point point) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double squared = dx * dx + dy * dy;
  if (squared == 0) return from;
  const double share =
      std::clamp(((point.x - from.x) * dx + (point.y - from.y) * dy) / squared, 0.0, 1.0);
  return {from.x + share * dx, from.y + share * dy};
}

struct PlaceOnLines {
  std::size_t joint = 0;  // before it
  Point point;
  double distance = std::numeric_limits<double>::infinity();
};

PlaceOnLines nearest_on_lines(std::span<const Point> joints, Point point, std::size_t from) {
  PlaceOnLines nearest;
  for (std::size_t i = std::min(from, joints.size() - 1); i < joints.size(); ++i) {
    const Point next = i + 1 < joints.size() ? joints[i + 1] : joints[i];
    const Point place = nearest_on_line(joints[i], next, point);
    const double apart = distance(place, point);
    if (apart < nearest.distance) nearest = {i, place, apart};
  }
  return nearest;
}

/// Rests of a path of lines. Those over cells begin at the middle of a cell; those over waypoints at the start, or at
/// the middle of its cell where the way from the start itself is not free.
class RestsOfLines {
 public:
  RestsOfLines(const FreeSpace& space, Adjacency adjacency, const Path& path, Point start)
      : space_(space), adjacency_(adjacency), path_(path), start_(start) {}

  /// From the start to a joint, over a point between them if there is one.
  void add(std::size_t joint, std::optional<Point> over = std::nullopt) {
    Path rest;
    if (const auto cells = path_.cells(); !cells.empty()) {
      rest.append(cell_at(start_));
      for (std::size_t i = joint; i < cells.size(); ++i) {
        if (rest.cells().back() != cells[i]) rest.append(cells[i]);
      }
      take_cheaper(best_, rest, check_any_angle_path(space_, adjacency_, rest.cells()));
      return;
    }
    if (!add_from(start_, joint, over)) add_from(centre_of(cell_at(start_)), joint, over);
  }

  std::optional<Plan> best() { return std::move(best_); }

 private:
  /// False if that is not free.
  bool add_from(Point start, std::size_t joint, std::optional<Point> over) {
    Path rest;
    rest.go_to(start);
    const auto go_on_to = [&](Point point) {
      if (!(rest.waypoints().back() == point)) rest.go_to(point);
    };
    if (over) go_on_to(*over);
    for (const Point point : path_.waypoints().subspan(joint)) go_on_to(point);
    const auto cost = check_any_angle_path(space_, adjacency_, rest.waypoints());
    take_cheaper(best_, std::move(rest), cost);
    return cost.has_value();
  }

  const FreeSpace& space_;
  Adjacency adjacency_;
  const Path& path_;
  Point start_;
  std::optional<Plan> best_;
};

/// How far apart are poses, where a radian counts as a cell?
double squared_difference(const Pose& a, const Pose& b) {
  const double turn = normalized_angle(a.heading - b.heading);
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return dx * dx + dy * dy + turn * turn;
}

/// The share of a segment at which it is nearest to a pose: sampled, and between the samples halved.
double nearest_share(const Segment& segment, const Pose& pose) {
  constexpr double kSpacing = 0.5;  // cells or radians
  constexpr int kHalvings = 40;
  const double size = std::abs(segment.length) + std::abs(segment.turn);
  const int count = std::max(1, static_cast<int>(std::ceil(size / kSpacing)));
  const auto difference = [&](double share) {
    return squared_difference(pose_on(segment, share), pose);
  };
  double best = 0;
  double least = difference(0);
  for (int i = 1; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    const double here = difference(share);
    if (here < least) best = share;
    least = std::min(least, here);
  }
  double step = 0.5 / count;
  for (int i = 0; i < kHalvings; ++i, step /= 2) {
    for (const double side : {-step, step}) {
      const double share = std::clamp(best + side, 0.0, 1.0);
      const double here = difference(share);
      if (here < least) best = share;
      least = std::min(least, here);
    }
  }
  return best < kRounding ? 0 : best > 1 - kRounding ? 1 : best;
}

}  // namespace

double farthest_from_path(const Frame& frame) {
  constexpr double kCells = 2;
  constexpr double kMetres = 0.3;
  return std::max(kCells, kMetres / frame.resolution);
}

bool is_worth_changing_to(double cost, double cost_of_rest, double keep) {
  return cost < (1 - keep) * cost_of_rest - kRounding * cost_of_rest;
}

std::optional<Plan> rest_of_steps(const FreeSpace& space, GridMoves moves,
                                  std::span<const Cell> cells, const Query& query,
                                  std::size_t& passed) {
  const auto start = cell_under(space, query.start.point());
  if (!start || cells.empty()) return std::nullopt;
  const auto ahead = cells.subspan(std::min(passed, cells.size() - 1));
  const auto nearest = std::ranges::min_element(
      ahead, {}, [&](Cell cell) { return squared_distance(*start, cell); });
  passed = static_cast<std::size_t>(nearest - ahead.begin()) + (cells.size() - ahead.size());
  const auto rest = cells.subspan(passed);
  std::optional<Plan> best;
  const auto join_at = [&](std::size_t index) {
    std::vector<Cell> joined = steps_towards(*start, rest[index], moves.connectivity);
    joined.insert(joined.end(), rest.begin() + static_cast<std::ptrdiff_t>(index), rest.end());
    const auto cost = check_grid_path(space, moves, joined);
    take_cheaper(best, Path(std::move(joined)), cost);
  };
  if (*start == rest.front()) {
    join_at(0);
  } else {
    for_each_doubling(rest.size() - 1, join_at);
  }
  return best;
}

std::optional<Plan> rest_of_lines(const FreeSpace& space, Adjacency adjacency, const Path& path,
                                  const Query& query, std::size_t& passed) {
  const auto start = cell_under(space, query.start.point());
  if (!start || path.empty() || path.driven()) return std::nullopt;
  const std::vector<Point> joints = path.points();
  const Point from = path.waypoints().empty() ? centre_of(*start) : query.start.point();
  const PlaceOnLines place = nearest_on_lines(joints, from, passed);
  passed = place.joint;
  RestsOfLines rests(space, adjacency, path, from);
  const std::size_t last = joints.size() - 1;
  const std::size_t next = std::min(place.joint + 1, last);
  rests.add(next);
  if (place.distance < kRounding) return rests.best();
  rests.add(next, place.point);
  for_each_doubling(last - next, [&](std::size_t i) { rests.add(next + i); });
  return rests.best();
}

PlaceOnDrive nearest_on_drive(const JoinedPoses& drive, const Pose& pose, std::size_t from) {
  const auto poses = drive.poses();
  PlaceOnDrive nearest;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](std::size_t joint, double share, const Pose& place) {
    const double difference = squared_difference(place, pose);
    if (difference >= least) return;
    least = difference;
    nearest = {joint, share, place, distance(place.point(), pose.point()),
               std::abs(normalized_angle(place.heading - pose.heading))};
  };
  for (std::size_t i = std::min(from, poses.size() - 1); i < poses.size(); ++i) {
    offer(i, 0, poses[i]);
    if (i + 1 == poses.size()) break;
    const Segment segment = drive.segment(i);
    const double reach = std::abs(segment.length) + std::abs(segment.turn);
    if (std::sqrt(squared_difference(poses[i], pose)) - reach > std::sqrt(least)) continue;
    const double share = nearest_share(segment, pose);
    if (share > 0 && share < 1) offer(i, share, pose_on(segment, share));
  }
  return nearest;
}

}  // namespace wend
