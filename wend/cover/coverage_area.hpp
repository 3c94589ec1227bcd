#pragma once

// What a tool in the middle of a robot can pass over: the cells whose centre is at most half the tool's width
// from a place of the robot, and which of them a path has covered.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "wend/geometry/line.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// A piece of a coverage path: waypoints in grid coordinates, at least one. Free from point to point.
using Stroke = std::vector<Point>;

/// The length of a stroke in cells.
double length_of(const Stroke& stroke);

/// Calls visit(cell) for the cells of a map of this size whose centre is within `reach` of the line. O(cells visited).
template <class Visit>
void visit_cells_near(const Line& line, double reach, int width, int height, Visit&& visit) {
  const double most = reach + 1e-9;
  const Point a = line.from;
  const Point b = line.to;
  const double length = line.length();
  const Point side =
      length > 0 ? Point{-(b.y - a.y) / length * most, (b.x - a.x) / length * most} : Point{0, 0};
  const int top = std::max(0, static_cast<int>(std::floor(std::min(a.y, b.y) - most - 0.5)));
  const int last = std::min(height - 1, static_cast<int>(std::ceil(std::max(a.y, b.y) + most)));
  for (int y = top; y <= last; ++y) {
    const double v = y + 0.5;
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    const auto extend = [&](double from, double to) {
      left = std::min(left, from);
      right = std::max(right, to);
    };
    for (const Point end : {a, b}) {
      const double rest = most * most - (v - end.y) * (v - end.y);
      if (rest >= 0) extend(end.x - std::sqrt(rest), end.x + std::sqrt(rest));
    }
    for (const double sign : {-1.0, 1.0}) {
      const double from = a.y + sign * side.y;
      const double to = b.y + sign * side.y;
      if (from == to || v < std::min(from, to) || v > std::max(from, to)) continue;
      const double x = a.x + sign * side.x + (b.x - a.x) * ((v - from) / (to - from));
      extend(x, x);
    }
    if (!(left <= right)) continue;
    const int first = std::max(0, static_cast<int>(std::ceil(left - 0.5)));
    const int end = std::min(width - 1, static_cast<int>(std::floor(right - 0.5)));
    for (int x = first; x <= end; ++x) visit(Cell{x, y});
  }
}

/// The cells that a tool is to cover, and those that it has covered.
class CoverageArea {
 public:
  /// Where the robot drives: the passable cells that are connected to `from`.
  CoverageArea(const FreeSpace& space, Cell from, double tool_width);

  /// Takes away the cells that are not in `area`.
  void confine_to(const BitGrid& area);
  /// Counts these cells as covered from the beginning.
  void add_covered(const BitGrid& covered);

  const FreeSpace& space() const { return space_; }
  /// The width of the tool in cells.
  double tool_width() const { return tool_width_; }
  /// How far from its middle the tool reaches, in cells.
  double reach() const { return tool_width_ / 2; }

  /// Can the robot be in the middle of this cell? False off the map.
  bool reachable(Cell cell) const { return reachable_.contains(cell) && reachable_[cell]; }
  const BitGrid& reachable() const { return reachable_; }
  /// The cells to cover, whether covered or not.
  const BitGrid& wanted() const { return wanted_; }
  /// The cells that are to be covered and are not yet.
  const BitGrid& left() const { return left_; }
  /// How many these are.
  std::size_t count_left() const { return count_left_; }

  /// May the robot drive along the line, at every heading? Exact up to rounding.
  bool free_along(Point from, Point to) const;

  /// Calls visit(cell) for the cells that are left and that the tool passes over along the line.
  template <class Visit>
  void visit_left(Point from, Point to, Visit&& visit) const {
    visit_cells_near({from, to}, reach(), left_.width(), left_.height(), [&](Cell cell) {
      if (left_[cell]) visit(cell);
    });
  }

  /// Covers what the tool passes over along the stroke.
  void cover(std::span<const Point> stroke);

 private:
  FreeSpace space_;
  double tool_width_;  // in cells
  BitGrid reachable_;
  BitGrid wanted_;
  BitGrid left_;
  std::size_t count_left_ = 0;
};

}  // namespace wend
