#include "wend/explore/visible_cells.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/cell_box.hpp"

namespace wend {
namespace {

/// A ray on one axis. It reaches the next border at border / speed of its length.
struct RayAxis {
  int step;       // to the next cell
  double border;  // how far off it is, in cells
  double speed;   // how far the whole ray leads, in cells

  static RayAxis of(double from, int cell, double way) {
    if (way < 0) return {-1, from - cell, -way};
    return {1, cell + 1 - from, way};
  }

  /// Does the ray end before the next border?
  bool ends() const { return border > speed; }
};

class Scan {
 public:
  Scan(const Obstacles& obstacles, Point from, double range, std::vector<Cell>& cells)
      : map_(obstacles.map()),
        blocked_(obstacles.blocked()),
        from_(from),
        here_(cell_at(from)),
        most_(range * range),
        // No ray leads further than over the map.
        reach_(static_cast<int>(std::min(
            std::ceil(range), static_cast<double>(std::max(map_.width(), map_.height()))))),
        box_(CellBox{here_, {here_.x + 1, here_.y + 1}}.grown_by(reach_).clipped_to(map_)),
        seen_(box_.width(), box_.height()),
        cells_(cells) {}

  /// Rays to points on the border of a square, which reach the middle line of each row and column in range at
  /// most half a cell apart.
  void run() {
    append(here_);
    const double side = reach_;
    for (int i = -2 * reach_; i <= 2 * reach_; ++i) {
      const double along = 0.5 * i;
      follow(along, -side);
      follow(along, side);
      if (std::abs(along) == side) continue;
      follow(-side, along);
      follow(side, along);
    }
  }

 private:
  /// Looks along a ray, up to the first blocked cell.
  void follow(double way_x, double way_y) {
    RayAxis x = RayAxis::of(from_.x, here_.x, way_x);
    RayAxis y = RayAxis::of(from_.y, here_.y, way_y);
    Cell cell = here_;
    while (true) {
      // Times both speeds, so that nothing is rounded from the middle of a cell.
      const double to_x = x.border * y.speed;
      const double to_y = y.border * x.speed;
      if (to_x <= to_y ? x.ends() : y.ends()) return;
      const Cell before = cell;
      if (to_x <= to_y) advance(x, cell.x);
      if (to_y <= to_x) advance(y, cell.y);
      if (!map_.contains(cell)) return;
      if (to_x == to_y && closed({cell.x, before.y}, {before.x, cell.y})) return;
      see(cell);
      if (blocked_[cell]) return;
    }
  }

  static void advance(RayAxis& axis, int& coordinate) {
    coordinate += axis.step;
    axis.border += 1;
  }

  /// Do two cells that touch at a corner stop a ray through it? Then they are seen.
  bool closed(Cell one, Cell other) {
    if (!blocked_[one] || !blocked_[other]) return false;
    see(one);
    see(other);
    return true;
  }

  void see(Cell cell) {
    const double dx = cell.x + 0.5 - from_.x;
    const double dy = cell.y + 0.5 - from_.y;
    if (dx * dx + dy * dy <= most_) append(cell);
  }

  void append(Cell cell) {
    const Cell bit{cell.x - box_.begin.x, cell.y - box_.begin.y};
    if (seen_[bit]) return;
    seen_.set(bit, true);
    cells_.push_back(cell);
  }

  const GridMap& map_;
  const BitGrid& blocked_;
  Point from_;
  Cell here_;
  double most_;  // squared distance
  int reach_;
  CellBox box_;  // of what can be seen
  BitGrid seen_;
  std::vector<Cell>& cells_;
};

}  // namespace

void append_visible_cells(const Obstacles& obstacles, Point from, double range,
                          std::vector<Cell>& cells) {
  const GridMap& map = obstacles.map();
  const bool inside = from.x >= 0 && from.y >= 0 && from.x < map.width() && from.y < map.height();
  if (inside && range >= 0) Scan(obstacles, from, range, cells).run();
}

}  // namespace wend
