#pragma once

// CarReference: the car's rules by brute force, as a reference for the planners. It shares no code
// with what it checks: of wend it reads the states of a GridMap, and its terrain through
// Reference.

#include <algorithm>
#include <functional>
#include <optional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "conformance/reference.hpp"
#include "tests/testing/car_motion.hpp"

namespace wend::test {

struct CarRules {
  int unit = 1;
  std::string straight_terrain = "none";
  double reverse_factor = 1;
};

class CarReference {
 public:
  struct Edge {
    std::size_t maneuver;
    std::size_t to;
    double fuel;
  };

  CarReference(const GridMap& map, Robot robot, CarRules rules)
      : map_(map),
        robot_(robot),
        rules_(std::move(rules)),
        cells_(map, robot, {.diagonals = false}),
        edges_(static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()) * 4),
        back_(edges_.size()) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      for (const Maneuver& maneuver : kManeuvers) {
        effects_.push_back(effect_of(quarter, maneuver, scale().y_up));
      }
    }
    for (std::size_t from = 0; from < edges_.size(); ++from) find_edges(from);
  }

  const GridMap& map() const { return map_; }
  const CarRules& rules() const { return rules_; }
  Scale scale() const { return {rules_.unit, map_.frame().y_up}; }
  int columns() const { return map_.width() / rules_.unit + 1; }
  int rows() const { return map_.height() / rules_.unit + 1; }

  std::size_t count() const { return edges_.size(); }
  std::size_t number(const Stand& stand) const {
    return static_cast<std::size_t>((stand.corner.y * columns() + stand.corner.x) * 4 +
                                    stand.quarter);
  }
  Stand stand(std::size_t number) const {
    const int corner = static_cast<int>(number / 4);
    return {{corner % columns(), corner / columns()}, static_cast<int>(number % 4)};
  }
  Pose pose(const Stand& stand) const {
    return {static_cast<double>(stand.corner.x) * rules_.unit,
            static_cast<double>(stand.corner.y) * rules_.unit,
            stand.quarter * std::numbers::pi / 2};
  }

  /// The nearest corner and heading, by looking at all of them; nothing for a pose off the map.
  std::optional<Stand> nearest(const Pose& pose) const {
    constexpr double kRounding = 1e-9;
    if (!(distance_to_interval(0, map_.width(), pose.x) <= kRounding)) return std::nullopt;
    if (!(distance_to_interval(0, map_.height(), pose.y) <= kRounding)) return std::nullopt;
    const auto least = [](int count, const std::function<double(int)>& off) {
      int best = 0;
      for (int i = 1; i < count; ++i) best = off(i) < off(best) ? i : best;
      return best;
    };
    return Stand{
        {least(columns(), [&](int i) { return std::abs(pose.x - i * rules_.unit); }),
         least(rows(), [&](int i) { return std::abs(pose.y - i * rules_.unit); })},
        least(4, [&](int i) { return -std::cos(pose.heading - i * std::numbers::pi / 2); })};
  }

  /// May a car stand there?
  bool passable(Cell corner) const {
    if (corner.x < 0 || corner.y < 0 || corner.x >= columns() || corner.y >= rows()) return false;
    for (const Cell cell : {Cell{corner.x - 1, corner.y - 1}, Cell{corner.x, corner.y - 1},
                            Cell{corner.x - 1, corner.y}, Cell{corner.x, corner.y}}) {
      if (blocked(cell)) return false;
    }
    const Cell point{corner.x * rules_.unit, corner.y * rules_.unit};
    return kept_clear(point,
                      [&](Cell square) { return distance_to_square(point.x, point.y, square); });
  }

  /// Is any map cell of a lattice cell an obstacle?
  bool blocked(Cell cell) const {
    bool blocked = false;
    for_map_cells(cell, [&](Cell map_cell) { blocked = blocked || is_obstacle(map_cell); });
    return blocked;
  }

  /// The mean multiplier of a lattice cell, or of what the map's edge leaves of it; nothing outside.
  std::optional<double> terrain(Cell cell) const {
    double sum = 0;
    int count = 0;
    for_map_cells(cell, [&](Cell map_cell) {
      sum += cells_.terrain(map_cell);
      ++count;
    });
    if (count == 0) return std::nullopt;
    return sum / count;
  }

  /// What straight moves pay between two lattice cells; along the map's edge there is one only.
  double straight_multiplier(Cell right, Cell left) const {
    if (rules_.straight_terrain == "none") return 1;
    const auto a = terrain(right);
    const auto b = terrain(left);
    if (!a || !b) return a ? *a : *b;
    return rules_.straight_terrain == "max" ? std::max(*a, *b) : (*a + *b) / 2;
  }

  const std::vector<Edge>& edges(std::size_t from) const { return edges_[from]; }
  bool is_obstacle(Cell cell) const {
    if (!map_.contains(cell)) return false;
    const CellState state = map_.state(cell);
    return state == CellState::occupied || (state == CellState::unknown && !robot_.enters_unknown);
  }

  /// Does every obstacle near a point, and the outside, keep the robot's radius from what `distance`
  /// measures?
  template <class Distance>
  bool kept_clear(Cell point, Distance&& distance) const {
    if (robot_.radius == 0) return true;
    const int reach = static_cast<int>(std::ceil(robot_.radius)) + rules_.unit + 1;
    for (int y = point.y - reach; y <= point.y + reach; ++y) {
      for (int x = point.x - reach; x <= point.x + reach; ++x) {
        const bool counts = map_.contains({x, y}) ? is_obstacle({x, y}) : robot_.stays_on_map;
        if (counts && distance(Cell{x, y}) < robot_.radius - 1e-7) return false;
      }
    }
    return true;
  }

  /// The least fuel from a stand to every other one (Dijkstra).
  std::vector<double> fuel_from(const Stand& start) const {
    return spread(edges_, {number(start)});
  }
  /// The least fuel from every stand to one of these.
  std::vector<double> fuel_to(const std::vector<Stand>& goals) const {
    std::vector<std::size_t> numbers;
    for (const Stand& goal : goals) numbers.push_back(number(goal));
    return spread(back_, numbers);
  }

 private:
  using Graph = std::vector<std::vector<Edge>>;

  template <class Visit>
  void for_map_cells(Cell cell, Visit&& visit) const {
    for (int y = cell.y * rules_.unit; y < (cell.y + 1) * rules_.unit; ++y) {
      for (int x = cell.x * rules_.unit; x < (cell.x + 1) * rules_.unit; ++x) {
        if (map_.contains({x, y})) visit(Cell{x, y});
      }
    }
  }

  void find_edges(std::size_t from) {
    const Stand stand = this->stand(from);
    if (!passable(stand.corner)) return;
    const auto at = [&](Cell by) { return Cell{stand.corner.x + by.x, stand.corner.y + by.y}; };
    const Cell point{stand.corner.x * rules_.unit, stand.corner.y * rules_.unit};
    for (std::size_t i = 0; i < kManeuvers.size(); ++i) {
      const Maneuver& maneuver = kManeuvers[i];
      const Effect& effect =
          effects_[static_cast<std::size_t>(stand.quarter) * kManeuvers.size() + i];
      if (!passable(at(effect.by))) continue;
      const auto distance = [&](Cell square) {
        const Cell offset{square.x - point.x, square.y - point.y};
        return distance_to_square(stand.quarter, maneuver, scale(), offset);
      };
      if (!kept_clear(point, distance)) continue;
      const double ground = maneuver.wheel == 0
                                ? straight_multiplier(at(effect.right), at(effect.left))
                                : terrain(at(effect.right)).value();
      const double fuel =
          maneuver.length() * ground * (maneuver.gear < 0 ? rules_.reverse_factor : 1);
      const std::size_t to = number({at(effect.by), effect.quarter});
      edges_[from].push_back({i, to, fuel});
      back_[to].push_back({i, from, fuel});
    }
  }

  static std::vector<double> spread(const Graph& graph, const std::vector<std::size_t>& seeds) {
    using Open = std::pair<double, std::size_t>;
    std::vector<double> fuel(graph.size(), kInfinite);
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    for (const std::size_t seed : seeds) {
      fuel[seed] = 0;
      open.emplace(0, seed);
    }
    while (!open.empty()) {
      const auto [so_far, from] = open.top();
      open.pop();
      if (so_far > fuel[from]) continue;
      for (const Edge& edge : graph[from]) {
        if (so_far + edge.fuel >= fuel[edge.to]) continue;
        fuel[edge.to] = so_far + edge.fuel;
        open.emplace(fuel[edge.to], edge.to);
      }
    }
    return fuel;
  }

  GridMap map_;
  Robot robot_;
  CarRules rules_;
  Reference cells_;
  std::vector<Effect> effects_;  // by quarter and maneuver
  Graph edges_;
  Graph back_;
};

}  // namespace wend::test
