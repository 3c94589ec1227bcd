#include "wend/path/exact_ends.hpp"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

constexpr double kSamePoint = 1e-6;  // cells: metres far from the origin are rounded

/// Are the cells of two points the same, or neighbours along an edge? A line between the points stays in them.
bool share_an_edge(Point a, Point b) {
  const Cell one = cell_at(a);
  const Cell other = cell_at(b);
  return one.x == other.x || one.y == other.y;
}

class Beginning {
 public:
  Beginning(const FreeSpace& space, Adjacency adjacency) : space_(space), adjacency_(adjacency) {}

  /// Makes the points begin at another point. False if they stay as they are.
  bool change(std::vector<Point>& points, Point start) const {
    const Point centre = points.front();
    if (distance(start, centre) <= kSamePoint) return false;
    const bool straight = points.size() > 1 && fits(start, points[1]) &&
                          (space_.uniform_terrain() || share_an_edge(start, points[1]));
    if (straight) {
      points.front() = start;
      return true;
    }
    if (!fits(start, centre)) return false;
    points.insert(points.begin(), start);
    return true;
  }

 private:
  bool fits(Point from, Point to) const {
    return disc_fits_along(space_, Line{from, to}, adjacency_);
  }

  const FreeSpace& space_;
  Adjacency adjacency_;
};

}  // namespace

Path with_ends(const Path& path, const PathEnds& ends, const FreeSpace& space,
               Adjacency adjacency) {
  assert(!path.empty() && !path.driven());
  const Beginning beginning(space, adjacency);
  std::vector<Point> points = path.points();
  const bool begins = beginning.change(points, ends.start);
  std::ranges::reverse(points);
  const bool stops = beginning.change(points, ends.goal);
  if (!begins && !stops) return path;
  std::ranges::reverse(points);
  return path.leads_over_cells() ? Path::over_cells(std::move(points))
                                 : Path::along(std::move(points));
}

}  // namespace wend
