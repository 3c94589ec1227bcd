#include "wend/robot/nearest_passable.hpp"

#include <algorithm>
#include <cstdlib>

namespace wend {
namespace {

/// Keeps the nearest of the cells that are offered and accepted.
class Nearest {
 public:
  Nearest(Cell from, const std::function<bool(Cell)>& accepts) : from_(from), accepts_(accepts) {}

  void offer(Cell cell) {
    const std::int64_t dx = std::int64_t{cell.x} - from_.x;
    const std::int64_t dy = std::int64_t{cell.y} - from_.y;
    const std::int64_t squared = dx * dx + dy * dy;
    const bool before = cell_ && (cell.y < cell_->y || (cell.y == cell_->y && cell.x < cell_->x));
    if (!cell_ || squared < squared_ || (squared == squared_ && before)) {
      if (!accepts_(cell)) return;
      cell_ = cell;
      squared_ = squared;
    }
  }

  /// Can a cell that is `ring` rows or columns away still win?
  bool open(std::int64_t ring) const { return !cell_ || ring * ring <= squared_; }

  std::optional<Cell> cell() const { return cell_; }

 private:
  Cell from_;
  const std::function<bool(Cell)>& accepts_;
  std::optional<Cell> cell_;
  std::int64_t squared_ = 0;
};

/// The distance of a coordinate from [0, size); 0 inside.
std::int64_t outside_by(int coordinate, int size) {
  return std::max<std::int64_t>(
      {0, -std::int64_t{coordinate}, std::int64_t{coordinate} - size + 1});
}

}  // namespace

std::optional<Cell> nearest_accepted(int width, int height, Cell from,
                                     const std::function<bool(Cell)>& accepts,
                                     DeadlineCheck& stop) {
  Nearest nearest(from, accepts);
  const std::int64_t first = std::max(outside_by(from.x, width), outside_by(from.y, height));
  const std::int64_t last =
      std::max({std::abs(std::int64_t{from.x}), std::abs(std::int64_t{width} - from.x),
                std::abs(std::int64_t{from.y}), std::abs(std::int64_t{height} - from.y)});
  for (std::int64_t ring = first; ring <= last && nearest.open(ring) && !stop.now(); ++ring) {
    // The part of the square ring that lies on the map: whole rows above and below, and between them
    // the first and the last column.
    const std::int64_t left = from.x - ring;
    const std::int64_t x_begin = std::max<std::int64_t>(left, 0);
    const std::int64_t x_end = std::min<std::int64_t>(from.x + ring, width - 1);
    const std::int64_t y_end = std::min<std::int64_t>(from.y + ring, height - 1);
    for (std::int64_t y = std::max<std::int64_t>(from.y - ring, 0); y <= y_end; ++y) {
      const bool whole_row = std::abs(y - from.y) == ring;
      for (std::int64_t x = whole_row ? x_begin : left; x <= x_end; x += whole_row ? 1 : 2 * ring) {
        if (x >= x_begin) nearest.offer({static_cast<int>(x), static_cast<int>(y)});
      }
    }
  }
  return nearest.cell();
}

std::optional<Cell> nearest_passable(const FreeSpace& space, Cell from,
                                     std::optional<Cell> connected_to, Adjacency adjacency) {
  return nearest_accepted(space.width(), space.height(), from, [&](Cell cell) {
    return space.passable(cell) &&
           (!connected_to || space.components().connected(cell, *connected_to, adjacency));
  });
}

}  // namespace wend
