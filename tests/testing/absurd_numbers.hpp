#pragma once

// Numbers that no map has: NaN, infinity, too large, too small. Paths and poses in which one of them stands in
// place of a coordinate.

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_path.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::test {

inline constexpr std::array kAbsurdNumbers{std::numeric_limits<double>::quiet_NaN(),
                                           std::numeric_limits<double>::infinity(),
                                           -std::numeric_limits<double>::infinity(),
                                           1e300,
                                           -1e300,
                                           1e18,
                                           -1e18,
                                           1e9,
                                           5e-324};

inline constexpr std::array kAbsurdCoordinates{std::numeric_limits<int>::min(), -(1 << 30), -1,
                                               1 << 30, std::numeric_limits<int>::max()};

inline double absurd_number(Random& random) {
  return kAbsurdNumbers[random.below(kAbsurdNumbers.size())];
}

/// An absurd number in place of one of the numbers, drawn by an index.
template <std::size_t Count>
void spoil(Random& random, std::array<double*, Count> numbers) {
  *numbers[random.below(Count)] = absurd_number(random);
}

inline Pose absurd_pose(Random& random, const FreeSpace& space) {
  Pose pose{number_between(random, 0, space.width()), number_between(random, 0, space.height()),
            number_between(random, -4, 4)};
  spoil<3>(random, {&pose.x, &pose.y, &pose.heading});
  return pose;
}

inline Point absurd_point(Random& random, const FreeSpace& space) {
  Point point{number_between(random, 0, space.width()), number_between(random, 0, space.height())};
  spoil<2>(random, {&point.x, &point.y});
  return point;
}

inline Cell absurd_cell(Random& random, const FreeSpace& space) {
  Cell cell = random_cell(random, space.width(), space.height());
  (random.chance(0.5) ? cell.x : cell.y) =
      kAbsurdCoordinates[random.below(kAbsurdCoordinates.size())];
  return cell;
}

/// Cells, waypoints or poses, one of which is absurd.
inline Path absurd_path(Random& random, const FreeSpace& space) {
  const Path good = random_path(random, space.width(), space.height());
  const std::size_t wrong = random.below(good.size());
  return good.visit(
      [&](std::span<const Cell> cells) {
        std::vector<Cell> all(cells.begin(), cells.end());
        all[wrong] = absurd_cell(random, space);
        return Path(std::move(all));
      },
      [&](std::span<const Point> points) {
        std::vector<Point> all(points.begin(), points.end());
        spoil<2>(random, {&all[wrong].x, &all[wrong].y});
        return Path::along(std::move(all));
      },
      [&](const JoinedPoses& drive) {
        std::vector<Pose> all(drive.poses().begin(), drive.poses().end());
        spoil<3>(random, {&all[wrong].x, &all[wrong].y, &all[wrong].heading});
        return Path::through(std::move(all));
      });
}

/// A small room with obstacles, in metres or in cells, for a robot of any kind.
inline FreeSpace any_space(Random& random) {
  const Frame metric{.resolution = 0.1, .origin = {1, -2, 0.3}, .y_up = true, .metric = true};
  const GridMap map = drawn_map(
      "....................\n....................\n......##............\n......##......#.....\n"
      "...............#....\n....................\n..#.................\n....................\n",
      random.chance(0.5) ? metric : Frame{});
  const double cell = map.frame().resolution;
  FreeSpaceOptions options;
  if (random.chance(0.3)) options.footprint = Footprint::disc(0.4 * cell);
  if (random.chance(0.3)) {
    options.footprint = *Footprint::polygon(
        *Polygon::make({{0.9 * cell, 0.4 * cell}, {0.9 * cell, -0.4 * cell}, {-0.5 * cell, 0}}));
  }
  options.outside = random.chance(0.5) ? OutsidePolicy::free : OutsidePolicy::blocked;
  return *make_free_space(map, options);
}

}  // namespace wend::test
