#include "wend/map/nearest_passable.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace wend {
namespace {

/// Keeps the nearest of the cells that are offered.
class Nearest {
 public:
  Nearest(const FreeSpace& space, Cell from, std::optional<Cell> connected_to, Adjacency adjacency)
      : space_(space), from_(from), connected_to_(connected_to), adjacency_(adjacency) {}

  void offer(Cell cell) {
    if (!space_.passable(cell)) return;
    if (connected_to_ && !space_.components().connected(cell, *connected_to_, adjacency_)) return;
    const std::int64_t dx = std::int64_t{cell.x} - from_.x;
    const std::int64_t dy = std::int64_t{cell.y} - from_.y;
    const std::int64_t squared = dx * dx + dy * dy;
    const bool before = cell_ && (cell.y < cell_->y || (cell.y == cell_->y && cell.x < cell_->x));
    if (!cell_ || squared < squared_ || (squared == squared_ && before)) {
      cell_ = cell;
      squared_ = squared;
    }
  }

  /// Can a cell that is `ring` rows or columns away still win?
  bool open(std::int64_t ring) const { return !cell_ || ring * ring <= squared_; }

  std::optional<Cell> cell() const { return cell_; }

 private:
  const FreeSpace& space_;
  Cell from_;
  std::optional<Cell> connected_to_;
  Adjacency adjacency_;
  std::optional<Cell> cell_;
  std::int64_t squared_ = 0;
};

/// How far outside [0, size) a coordinate lies.
std::int64_t outside_by(int coordinate, int size) {
  return std::max<std::int64_t>(
      {0, -std::int64_t{coordinate}, std::int64_t{coordinate} - size + 1});
}

}  // namespace

std::optional<Cell> nearest_passable(const FreeSpace& space, Cell from,
                                     std::optional<Cell> connected_to, Adjacency adjacency) {
  Nearest nearest(space, from, connected_to, adjacency);
  const std::int64_t first =
      std::max(outside_by(from.x, space.width()), outside_by(from.y, space.height()));
  const std::int64_t last =
      std::max({std::abs(std::int64_t{from.x}), std::abs(std::int64_t{space.width()} - from.x),
                std::abs(std::int64_t{from.y}), std::abs(std::int64_t{space.height()} - from.y)});
  for (std::int64_t ring = first; ring <= last && nearest.open(ring); ++ring) {
    // The part of the square ring that lies on the map: two rows, and two columns between them.
    const std::int64_t left = from.x - ring;
    const std::int64_t right = from.x + ring;
    const std::int64_t top = from.y - ring;
    const std::int64_t bottom = from.y + ring;
    const auto x_begin = std::max<std::int64_t>(left, 0);
    const auto x_end = std::min<std::int64_t>(right, space.width() - 1);
    for (const std::int64_t y : {top, bottom}) {
      if (y < 0 || y >= space.height()) continue;
      for (std::int64_t x = x_begin; x <= x_end; ++x) {
        nearest.offer({static_cast<int>(x), static_cast<int>(y)});
      }
    }
    const auto y_begin = std::max<std::int64_t>(top + 1, 0);
    const auto y_end = std::min<std::int64_t>(bottom - 1, space.height() - 1);
    for (const std::int64_t x : {left, right}) {
      if (x < 0 || x >= space.width()) continue;
      for (std::int64_t y = y_begin; y <= y_end; ++y) {
        nearest.offer({static_cast<int>(x), static_cast<int>(y)});
      }
    }
  }
  return nearest.cell();
}

}  // namespace wend
