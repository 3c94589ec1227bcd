#include "wend/planner/any_angle/taut_path.hpp"

#include <utility>
#include <vector>

#include "wend/path/smoothing/simplification.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/sight/cell_trail.hpp"

namespace wend {

bool goes_straight_on(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x);
}

bool disc_fits_along_path(const FreeSpace& space, const Path& path, Adjacency adjacency) {
  const std::span<const Point> waypoints = path.waypoints();
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    if (!disc_fits_along(space, Line{waypoints[i - 1], waypoints[i]}, adjacency)) return false;
  }
  return true;
}

bool write_pulled_trail(const FreeSpace& space, Adjacency adjacency, const Portals& portals,
                        Cell start, std::span<const std::uint32_t> corners, Cell goal, Path& path) {
  std::vector<Cell> cells;
  if (!write_trail(portals, start, corners, goal, cells)) return false;
  const auto pulled = string_pulled(Path(std::move(cells)), space, adjacency);
  if (!pulled) return false;
  path.clear();
  for (const Point point : pulled->waypoints()) path.go_to(point);
  return true;
}

}  // namespace wend
