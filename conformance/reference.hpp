#pragma once

// Reference: what the rules of a grid say, by brute force, to check planners against. It shares no
// code with what it checks: of wend it reads the states and terrain of a GridMap, and the options of
// a robot.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "conformance/visibility.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::test {

struct Robot {
  double radius = 0;  // cells
  bool enters_unknown = false;
  bool stays_on_map = false;      // the whole disc, not just its centre
  double clearance_distance = 0;  // cells
  double clearance_cost = 0;
};

inline Robot robot_in_cells(const FreeSpaceOptions& options, const Frame& frame) {
  const auto in_metres = frame.metric ? OutsidePolicy::blocked : OutsidePolicy::free;
  return {.radius = options.footprint.circumscribed_radius() / frame.resolution,
          .enters_unknown = options.unknown == UnknownPolicy::free,
          .stays_on_map = options.outside.value_or(in_metres) == OutsidePolicy::blocked,
          .clearance_distance = options.clearance_distance / frame.resolution,
          .clearance_cost = options.clearance_cost};
}

struct Rules {
  bool diagonals = true;
  int corners_cut = 0;  // how many of the two cells beside a diagonal step may be blocked
};

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Distance between a closed interval [low, high] and a number.
inline double distance_to_interval(double low, double high, double value) {
  return std::max({low - value, value - high, 0.0});
}

/// Distance from a point to the closed unit square of a cell.
inline double distance_to_square(double x, double y, Cell square) {
  return std::hypot(distance_to_interval(square.x, square.x + 1, x),
                    distance_to_interval(square.y, square.y + 1, y));
}

/// Distance from a segment to the closed square of a cell: the least over t of a convex function, by ternary search.
inline double distance_to_square(Point from, Point to, Cell square) {
  const auto at = [&](double t) {
    return distance_to_square(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), square);
  };
  double low = 0;
  double high = 1;
  for (int i = 0; i < 60; ++i) {
    const double third = (high - low) / 3;
    if (at(low + third) <= at(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return std::min({at(0), at(1), at((low + high) / 2)});
}

/// The same between the centres of two cells.
inline double distance_to_square(Cell from, Cell to, Cell square) {
  return distance_to_square(Point{from.x + 0.5, from.y + 0.5}, Point{to.x + 0.5, to.y + 0.5},
                            square);
}

class Reference {
 public:
  Reference(const GridMap& map, Robot robot, Rules rules)
      : map_(map),
        robot_(robot),
        rules_(rules),
        passable_(map.size()),
        terrain_(map.size()),
        edges_(map.size()) {
    for_all_cells([&](Cell cell) { passable_[number(cell)] = far_from_obstacles(cell); });
    for_all_cells([&](Cell cell) { terrain_[number(cell)] = terrain_of(cell); });
    for_all_cells([&](Cell cell) { find_edges(cell); });
  }

  bool passable(Cell cell) const { return map_.contains(cell) && passable_[number(cell)]; }

  bool is_step(Cell from, Cell to) const {
    if (!map_.contains(from) || !map_.contains(to)) return false;
    const auto& edges = edges_[number(from)];
    return std::any_of(edges.begin(), edges.end(),
                       [&](const Edge& edge) { return edge.to == number(to); });
  }

  /// Length times the mean of the two terrain multipliers.
  double step_cost(Cell from, Cell to) const {
    return std::hypot(from.x - to.x, from.y - to.y) * (terrain(from) + terrain(to)) / 2;
  }

  /// The map's multiplier, and more where the robot keeps away from an obstacle, as it is stored.
  double terrain(Cell cell) const { return terrain_[number(cell)]; }
  /// Does every cell cost the same as its length?
  bool uniform() const {
    return std::all_of(terrain_.begin(), terrain_.end(), [](double here) { return here == 1; });
  }

  double cost_of(std::span<const Cell> path) const {
    double cost = 0;
    for (std::size_t i = 1; i < path.size(); ++i) cost += step_cost(path[i - 1], path[i]);
    return cost;
  }

  /// The integral of the multipliers along the line between two centres: cut at all borders, piece by piece.
  double line_cost(Cell from, Cell to) const {
    if (uniform()) return std::hypot(from.x - to.x, from.y - to.y);
    std::vector<double> cuts{0, 1};
    for (const auto& [begin, end] : {std::pair{from.x, to.x}, std::pair{from.y, to.y}}) {
      for (int border = std::min(begin, end) + 1; border <= std::max(begin, end); ++border) {
        cuts.push_back((border - (begin + 0.5)) / (end - begin));
      }
    }
    std::sort(cuts.begin(), cuts.end());
    double mean = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const double middle = (cuts[i - 1] + cuts[i]) / 2;
      const Cell cell{static_cast<int>(std::floor(from.x + 0.5 + middle * (to.x - from.x))),
                      static_cast<int>(std::floor(from.y + 0.5 + middle * (to.y - from.y)))};
      const bool squeezed = robot_.clearance_distance > 0 && !passable(cell);
      mean += (cuts[i] - cuts[i - 1]) * terrain(cell) * (squeezed ? 1 + robot_.clearance_cost : 1);
    }
    return std::hypot(from.x - to.x, from.y - to.y) * mean;
  }

  /// The same for a path whose cells are joined by lines.
  double any_angle_cost_of(std::span<const Cell> path) const {
    double cost = 0;
    for (std::size_t i = 1; i < path.size(); ++i) cost += line_cost(path[i - 1], path[i]);
    return cost;
  }

  /// What is wrong with a path of steps from one cell to another; empty if nothing is.
  std::string fault(std::span<const Cell> path, Cell from, Cell to) const {
    return fault(path, from, to, "step", [&](Cell a, Cell b) { return is_step(a, b); });
  }

  /// What is wrong with a path whose cells are joined by lines; empty if nothing is.
  std::string any_angle_fault(std::span<const Cell> path, Cell from, Cell to) const {
    return fault(path, from, to, "line", [&](Cell a, Cell b) { return is_free_line(a, b); });
  }

  /// The same for waypoints. A point is held to the rules of Visibility, a disc keeps its distance.
  std::string waypoint_fault(std::span<const Point> path, Cell from, Point to) const {
    if (robot_.radius == 0) return visibility().fault(path, from, to);
    if (path.empty() || path.front() != centre_of(from) || path.back() != to) {
      return "the path does not join start and goal";
    }
    if (!passable(from) || !passable(cell_at(to))) return "an end is blocked";
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Point a = path[i - 1];
      const Point b = path[i];
      const auto near = [&](Cell square) { return distance_to_square(a, b, square); };
      const int reach = static_cast<int>(std::ceil(robot_.radius)) + 1;
      for (int y = floor_of(std::min(a.y, b.y)) - reach; y <= std::max(a.y, b.y) + reach; ++y) {
        for (int x = floor_of(std::min(a.x, b.x)) - reach; x <= std::max(a.x, b.x) + reach; ++x) {
          if (is_obstacle({x, y}) && near({x, y}) < robot_.radius - 1e-7) {
            return "line " + std::to_string(i) + " is too near to an obstacle";
          }
        }
      }
    }
    return {};
  }

  static double length_of(std::span<const Point> path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      length += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    }
    return length;
  }

  /// The shortest paths of a point among the passable cells.
  Visibility visibility() const {
    const auto free = [this](Cell cell) { return passable(cell); };
    return {map_.width(), map_.height(), free, rules_.diagonals && rules_.corners_cut == 2};
  }

  /// The cheapest cost from one cell to every cell (Dijkstra).
  std::vector<double> costs_from(Cell start) const {
    return spread(start, [](const Edge& edge) { return edge.cost; });
  }

  /// The fewest steps from one cell to every cell.
  std::vector<double> steps_from(Cell start) const {
    return spread(start, [](const Edge&) { return 1.0; });
  }

  std::size_t number(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(map_.width()) +
           static_cast<std::size_t>(cell.x);
  }

 private:
  static int floor_of(double value) { return static_cast<int>(std::floor(value)); }

  struct Edge {
    std::size_t to;
    double cost;
  };

  template <class Joined>
  std::string fault(std::span<const Cell> path, Cell from, Cell to, const char* piece,
                    const Joined& joined) const {
    std::ostringstream what;
    if (path.empty() || path.front() != from || path.back() != to) {
      what << "the path does not join start and goal";
    }
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (!passable(path[i])) what << "; (" << path[i].x << "," << path[i].y << ") is blocked";
      if (i > 0 && !joined(path[i - 1], path[i]))
        what << "; " << piece << " " << i << " is illegal";
    }
    return what.str();
  }

  template <class Visit>
  void for_all_cells(Visit&& visit) const {
    for (int y = 0; y < map_.height(); ++y) {
      for (int x = 0; x < map_.width(); ++x) visit(Cell{x, y});
    }
  }

  bool is_obstacle(Cell cell) const {
    if (!map_.contains(cell)) return robot_.stays_on_map;
    const CellState state = map_.state(cell);
    return state == CellState::occupied || (state == CellState::unknown && !robot_.enters_unknown);
  }

  /// The least that `distance` says of the obstacles that can be so near to `around`. Of the cells
  /// outside the map those along its edge are nearest.
  template <class Distance>
  double least_distance(Cell around, double near, Distance&& distance) const {
    const int reach = static_cast<int>(std::ceil(near)) + 2;
    const Cell last{std::min(around.x + reach, map_.width()),
                    std::min(around.y + reach, map_.height())};
    double least = kInfinite;
    for (int y = std::max(around.y - reach, -1); y <= last.y; ++y) {
      for (int x = std::max(around.x - reach, -1); x <= last.x; ++x) {
        if (is_obstacle({x, y})) least = std::min(least, distance(Cell{x, y}));
      }
    }
    return least;
  }

  /// Do all obstacles near `around` keep the robot's radius from what `distance` measures?
  template <class Distance>
  bool kept_clear(Cell around, Distance&& distance) const {
    return least_distance(around, robot_.radius, distance) >= robot_.radius - 1e-7;
  }

  /// Rounded to 1/256, a half up.
  double terrain_of(Cell cell) const {
    return std::max(1.0, std::floor(exact_terrain_of(cell) * 256 + 0.5) / 256);
  }

  double exact_terrain_of(Cell cell) const {
    if (robot_.clearance_distance == 0 || !passable(cell)) return map_.terrain(cell);
    const double clearance = least_distance(
        cell, robot_.radius + robot_.clearance_distance,
        [&](Cell square) { return distance_to_square(cell.x + 0.5, cell.y + 0.5, square); });
    const double share =
        std::min(std::max(0.0, clearance - robot_.radius) / robot_.clearance_distance, 1.0);
    return map_.terrain(cell) * (1 + robot_.clearance_cost * std::pow(1 - share, 2));
  }

  bool far_from_obstacles(Cell cell) const {
    return !is_obstacle(cell) && kept_clear(cell, [&](Cell square) {
      return distance_to_square(cell.x + 0.5, cell.y + 0.5, square);
    });
  }

  /// Does the robot fit along the line between the centres of two cells?
  bool is_free_line(Cell from, Cell to) const {
    const int reach = static_cast<int>(std::ceil(robot_.radius)) + 1;
    for (int y = std::min(from.y, to.y) - reach; y <= std::max(from.y, to.y) + reach; ++y) {
      for (int x = std::min(from.x, to.x) - reach; x <= std::max(from.x, to.x) + reach; ++x) {
        if (robot_.radius == 0 && squeezes_through(from, to, {x, y})) return false;
        if (!is_obstacle({x, y})) continue;
        if (robot_.radius == 0 ? enters(from, to, {x, y})
                               : distance_to_square(from, to, {x, y}) < robot_.radius - 1e-7) {
          return false;
        }
      }
    }
    return true;
  }

  /// On which side of the line between two centres is a corner, (x, y)? 0: on the line. Exact.
  static long side(Cell from, Cell to, int x, int y) {
    const long dx = to.x - from.x;
    const long dy = to.y - from.y;
    return dx * (2L * (y - from.y) - 1) - dy * (2L * (x - from.x) - 1);
  }

  /// Does the line enter the interior of a square? Then two of its corners lie on either side.
  static bool enters(Cell from, Cell to, Cell square) {
    if (square.x < std::min(from.x, to.x) || square.x > std::max(from.x, to.x)) return false;
    if (square.y < std::min(from.y, to.y) || square.y > std::max(from.y, to.y)) return false;
    bool left = false;
    bool right = false;
    for (const Cell corner : {Cell{0, 0}, Cell{1, 0}, Cell{0, 1}, Cell{1, 1}}) {
      const long where = side(from, to, square.x + corner.x, square.y + corner.y);
      left = left || where > 0;
      right = right || where < 0;
    }
    return left && right;
  }

  /// Does the line pass between two obstacles that touch at the first corner of a cell?
  bool squeezes_through(Cell from, Cell to, Cell cell) const {
    if (rules_.diagonals && rules_.corners_cut == 2) return false;
    if (cell.x <= std::min(from.x, to.x) || cell.x > std::max(from.x, to.x)) return false;
    if (cell.y <= std::min(from.y, to.y) || cell.y > std::max(from.y, to.y)) return false;
    if (side(from, to, cell.x, cell.y) != 0) return false;
    const bool falling = is_obstacle(cell) && is_obstacle({cell.x - 1, cell.y - 1});
    const bool rising = is_obstacle({cell.x - 1, cell.y}) && is_obstacle({cell.x, cell.y - 1});
    return falling || rising;
  }

  bool step_allowed(Cell from, Cell to) const {
    if (!passable(from) || !passable(to)) return false;
    if (from.x == to.x || from.y == to.y) return true;
    if (!rules_.diagonals) return false;
    const int blocked = (passable({from.x, to.y}) ? 0 : 1) + (passable({to.x, from.y}) ? 0 : 1);
    if (blocked > rules_.corners_cut) return false;
    return blocked == 0 || robot_.radius == 0 ||
           kept_clear(from, [&](Cell square) { return distance_to_square(from, to, square); });
  }

  void find_edges(Cell from) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell to{from.x + dx, from.y + dy};
        if (to == from || !step_allowed(from, to)) continue;
        edges_[number(from)].push_back({number(to), step_cost(from, to)});
      }
    }
  }

  template <class Cost>
  std::vector<double> spread(Cell start, Cost&& cost_of_edge) const {
    std::vector<double> costs(map_.size(), kInfinite);
    if (!passable(start)) return costs;
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    costs[number(start)] = 0;
    open.emplace(0, number(start));
    while (!open.empty()) {
      const auto [cost, cell] = open.top();
      open.pop();
      if (cost > costs[cell]) continue;
      for (const Edge& edge : edges_[cell]) {
        const double other = cost + cost_of_edge(edge);
        if (other >= costs[edge.to]) continue;
        costs[edge.to] = other;
        open.emplace(other, edge.to);
      }
    }
    return costs;
  }

  GridMap map_;
  Robot robot_;
  Rules rules_;
  std::vector<bool> passable_;
  std::vector<double> terrain_;
  std::vector<std::vector<Edge>> edges_;
};

}  // namespace wend::test
