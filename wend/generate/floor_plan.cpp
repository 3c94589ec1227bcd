#include "wend/generate/floor_plan.hpp"

#include <type_traits>

namespace wend {

FloorPlan::FloorPlan(int width, int height)
    : cells_(width, height, CellState::unknown), kept_free_(width, height, 0) {
  const Block spot = Block{0, 0, 1, 1}.grown(4);
  keep_free({kFreeCorner + spot.x, kFreeCorner + spot.y, spot.width, spot.height});
  keep_free({width - 1 - kFreeCorner + spot.x, height - 1 - kFreeCorner + spot.y, spot.width,
             spot.height});
}

void FloorPlan::build(std::span<const Block> floors) {
  for (const Block& floor : floors) fill(cells_, floor.grown(kOuterWall), CellState::occupied);
  for (const Block& floor : floors) fill(cells_, floor, CellState::free);
}

bool FloorPlan::is_outside(Cell cell) const {
  return !cells_.contains(cell) || cells_[cell] == CellState::unknown;
}

void FloorPlan::cut_window(const Block& inner, Cell outwards) {
  const auto layer = [&](int depth) {
    return Block{inner.x + depth * outwards.x, inner.y + depth * outwards.y, inner.width,
                 inner.height};
  };
  for (int depth = 0; depth < kOuterWall; ++depth) {
    if (!all_equal(cells_, layer(depth), CellState::occupied)) return;
  }
  const Block behind = layer(kOuterWall);
  if (!is_outside({behind.x, behind.y}) || !is_outside({behind.x_end() - 1, behind.y_end() - 1})) {
    return;
  }
  fill(cells_, layer(1), CellState::unknown);
}

void FloorPlan::cut_windows(const Block& floor) {
  constexpr int kPitch = 16;  // from one window to the next
  constexpr int kPost = 4;    // wall between two windows
  const auto along = [](int length, auto&& cut) {
    const int windows = std::max(1, length / kPitch);
    for (int i = 0; i < windows; ++i) {
      const int begin = i * length / windows + kPost / 2;
      cut(begin, (i + 1) * length / windows - kPost / 2 - begin);
    }
  };
  along(floor.width, [&](int begin, int length) {
    cut_window({floor.x + begin, floor.y - 1, length, 1}, {0, -1});
    cut_window({floor.x + begin, floor.y_end(), length, 1}, {0, 1});
  });
  along(floor.height, [&](int begin, int length) {
    cut_window({floor.x - 1, floor.y + begin, 1, length}, {-1, 0});
    cut_window({floor.x_end(), floor.y + begin, 1, length}, {1, 0});
  });
}

bool FloorPlan::place(const Block& piece) {
  if (piece.width <= 0 || piece.height <= 0 || !all_equal(cells_, piece, CellState::free) ||
      !all_equal(kept_free_, piece, static_cast<unsigned char>(0))) {
    return false;
  }
  fill(cells_, piece, CellState::occupied);
  fill(cells_, piece.grown(-1), CellState::unknown);
  return true;
}

bool FloorPlan::place_round(Cell centre, int radius) {
  const Block square = Block{centre.x, centre.y, 1, 1}.grown(radius);
  if (!all_equal(cells_, square, CellState::free) ||
      !all_equal(kept_free_, square, static_cast<unsigned char>(0))) {
    return false;
  }
  // Circles of cells look round if the radius is slightly larger.
  const auto within = [&](int x, int y, int r) {
    const int dx = x - centre.x;
    const int dy = y - centre.y;
    return r >= 0 && dx * dx + dy * dy <= r * r + r;
  };
  for (int y = square.y; y < square.y_end(); ++y) {
    for (int x = square.x; x < square.x_end(); ++x) {
      if (within(x, y, radius)) cells_[{x, y}] = CellState::occupied;
      if (within(x, y, radius - 1)) cells_[{x, y}] = CellState::unknown;
    }
  }
  return true;
}

void FloorPlan::transpose() {
  const auto transposed = [](const auto& grid) {
    std::remove_cvref_t<decltype(grid)> result(grid.height(), grid.width());
    for (const Cell cell : every_cell(grid)) result[{cell.y, cell.x}] = grid[cell];
    return result;
  };
  cells_ = transposed(cells_);
  kept_free_ = transposed(kept_free_);
}

GridMap FloorPlan::map() const {
  return *make_grid_map(cells_,
                        {.resolution = kMetresPerCell, .origin = {}, .y_up = true, .metric = true});
}

}  // namespace wend
