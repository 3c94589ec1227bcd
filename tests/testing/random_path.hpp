#pragma once

// Random paths for tests, of cells, waypoints and a car's poses; most run into something.

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/random_arc.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/robot/nearest_passable.hpp"

namespace wend::test {

/// On a grid of `width` x `height` cells, in steps to neighbours and some longer steps.
inline Path random_cell_path(Random& random, int width, int height) {
  Path path({random_cell(random, width, height)});
  for (int i = random.between(0, 12); i > 0; --i) {
    const auto direction = static_cast<Direction>(random.between(0, kDirections - 1));
    const Cell next = random.chance(0.1) ? random_cell(random, width, height)
                                         : step(path.cells().back(), direction);
    if (next.x >= 0 && next.y >= 0 && next.x < width && next.y < height) path.append(next);
  }
  return path;
}

/// Half of them in multiples of half a cell, so that they touch edges and corners.
inline Path random_waypoint_path(Random& random, int width, int height) {
  const bool on_halves = random.chance(0.5);
  const auto rounded = [&](double value) { return on_halves ? std::round(2 * value) / 2 : value; };
  std::vector<Point> points{
      {rounded(number_between(random, 0, width)), rounded(number_between(random, 0, height))}};
  for (int i = random.between(0, 8); i > 0; --i) {
    const Point last = points.back();
    points.push_back({rounded(last.x + number_between(random, -2, 2)),
                      rounded(last.y + number_between(random, -2, 2))});
  }
  return Path::along(points);
}

/// As a car drives, and with arcs of any radius; it leaves the map now and then.
inline Path random_drive(Random& random, int width, int height) {
  std::vector<Pose> poses;
  for (int i = random.between(0, 5); i >= 0; --i) {
    Arc arc = random_arc(random, width, height);
    if (!poses.empty()) arc.from = poses.back();
    if (std::abs(arc.turn()) > kPi) arc.length = kPi / 2 / arc.curvature;
    if (poses.empty()) poses.push_back(arc.from);
    poses.push_back(end_of(arc));
  }
  return Path::through(poses);
}

inline Path random_path(Random& random, int width, int height) {
  switch (random.below(3)) {
    case 0:
      return random_cell_path(random, width, height);
    case 1:
      return random_waypoint_path(random, width, height);
    default:
      return random_drive(random, width, height);
  }
}

/// Waypoints, free by first_collision(): it wanders on as long as it finds a way. Half of them go by
/// half cells, along edges of obstacles and by their corners. Empty if the robot can stand nowhere.
inline Path random_free_path(Random& random, const FreeSpace& space, Adjacency adjacency) {
  const auto start = nearest_passable(space, random_cell(random, space.width(), space.height()));
  if (!start) return {};
  const bool by_halves = random.chance(0.5);
  std::vector<Point> points{centre_of(*start)};
  int direction = random.between(0, kDirections - 1);
  for (int i = one_of<int>(random, std::array{0, 1, 5, 30, 60}); i > 0; --i) {
    if (random.chance(0.3)) direction = random.between(0, kDirections - 1);
    const Cell way = kDirectionSteps[static_cast<std::size_t>(direction)];
    const double far = by_halves ? random.between(1, 2) / 2.0 : number_between(random, 0, 2);
    points.push_back({points.back().x + way.x * far, points.back().y + way.y * far});
    if (!first_collision(Path::along(points), space, adjacency)) continue;
    points.pop_back();
    direction = random.between(0, kDirections - 1);
  }
  return Path::along(points);
}

inline std::string text_of(const Path& path) {
  std::ostringstream text;
  text.precision(17);
  text << (path.driven() ? "driven" : "lines");
  for (const Pose& pose : path.poses()) text << " (" << pose.x << "," << pose.y << ")";
  return text.str();
}

}  // namespace wend::test
