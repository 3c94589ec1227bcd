#pragma once

// SampledRobot: says of single points whether a robot collides there. Asked at many points of a path
// it checks what sweeps say; it shares no code with them.

#include <algorithm>
#include <cmath>

#include "conformance/reference.hpp"
#include "wend/map/grid_map.hpp"

namespace wend::test {

class SampledRobot {
 public:
  /// Unknown cells are obstacles. The radius is in cells. The map outlives the robot.
  SampledRobot(const GridMap& map, double radius, bool stays_on_map)
      : map_(map), radius_(radius), margin_(stays_on_map ? radius : 0) {}

  bool is_obstacle(int x, int y) const {
    return map_.contains({x, y}) && map_.state({x, y}) != CellState::free;
  }

  /// Is it, by more than rounding, off the map, inside of the obstacles, or too close to one?
  bool collides_at(Point point) const {
    constexpr double kRounding = 1e-7;
    if (inside_border(point) < margin_ - kRounding) return true;
    return radius_ == 0 ? is_inside(point, kRounding)
                        : nearest_obstacle(point) < radius_ - kRounding;
  }

  /// From the map's border, negative outside.
  double inside_border(Point point) const {
    return std::min({point.x, map_.width() - point.x, point.y, map_.height() - point.y});
  }

  /// To the nearest obstacle within the radius and a cell more; else infinite.
  double nearest_obstacle(Point point) const {
    const double reach = radius_ + 1;
    double least = kInfinite;
    for (int y = floor(point.y - reach); y <= floor(point.y + reach); ++y) {
      for (int x = floor(point.x - reach); x <= floor(point.x + reach); ++x) {
        if (is_obstacle(x, y))
          least = std::min(least, distance_to_square(point.x, point.y, {x, y}));
      }
    }
    return least;
  }

  /// Do exactly two obstacles touch at this corner, diagonally?
  bool is_gap(int x, int y) const {
    const bool rising = is_obstacle(x, y);
    return is_obstacle(x - 1, y - 1) == rising && is_obstacle(x - 1, y) != rising &&
           is_obstacle(x, y - 1) != rising;
  }

 private:
  static int floor(double value) { return static_cast<int>(std::floor(value)); }

  /// Deeper in the union of obstacles than that: everything around it is blocked.
  bool is_inside(Point point, double depth) const {
    for (const double dy : {-depth, depth}) {
      for (const double dx : {-depth, depth}) {
        if (!is_obstacle(floor(point.x + dx), floor(point.y + dy))) return false;
      }
    }
    return true;
  }

  const GridMap& map_;
  double radius_;
  double margin_;  // of the centre, from the map's border
};

}  // namespace wend::test
