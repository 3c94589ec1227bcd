#include "wend/map/grid_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace wend {
namespace {

/// Sets the cells of one state in a row of a bit plane that is all false.
void set_state(std::span<std::uint64_t> words, std::span<const CellState> row, CellState state) {
  set_row(words, row, [state](CellState here) { return here == state; });
}

BitGrid plane(const Grid<CellState>& cells, CellState state) {
  BitGrid bits(cells.width(), cells.height());
  for (int y = 0; y < cells.height(); ++y) set_state(bits.row_words(y), cells.row(y), state);
  return bits;
}

void turn_over(BitGrid& plane) {
  for (int y = 0; y < plane.height() / 2; ++y) {
    const auto row = plane.row_words(y);
    std::swap_ranges(row.begin(), row.end(), plane.row_words(plane.height() - 1 - y).begin());
  }
}

}  // namespace

GridMap::GridMap(const Grid<CellState>& cells, Frame frame, Grid<double> terrain)
    : GridMap(plane(cells, CellState::occupied), plane(cells, CellState::unknown), frame,
              std::move(terrain)) {}

GridMap::GridMap(BitGrid occupied, BitGrid unknown, Frame frame, Grid<double> terrain) {
  assert(occupied.width() > 0 && occupied.height() > 0);
  assert(occupied.width() == unknown.width() && occupied.height() == unknown.height());
  assert(terrain.empty() ||
         (terrain.width() == occupied.width() && terrain.height() == occupied.height()));
  assert(std::all_of(terrain.values().begin(), terrain.values().end(), [](double multiplier) {
    return multiplier >= 1 && std::isfinite(multiplier);
  }));
  assert(frame.resolution > 0);
  const auto values = terrain.values();
  if (std::all_of(values.begin(), values.end(), [](double value) { return value == 1; })) {
    terrain = {};
  }
  data_ = std::make_shared<const Data>(
      Data{std::move(occupied), std::move(unknown), std::move(terrain), frame});
}

GridMap GridMap::with_frame(Frame frame) const {
  Data copy = *data_;
  copy.frame = frame;
  return GridMap(std::make_shared<const Data>(std::move(copy)));
}

GridMapBuilder::GridMapBuilder(int width) : occupied_(width, 0), unknown_(width, 0) {
  assert(width >= 1);
}

void GridMapBuilder::reserve(int height) {
  occupied_.reserve_rows(height);
  unknown_.reserve_rows(height);
}

void GridMapBuilder::append(std::span<const CellState> states, std::span<const double> terrain) {
  assert(states.size() == static_cast<std::size_t>(width()));
  assert(terrain.empty() || terrain.size() == states.size());
  const bool uniform = std::all_of(terrain.begin(), terrain.end(),
                                   [](double multiplier) { return multiplier == 1; });
  if (!uniform || !terrain_.empty()) {
    terrain_.resize(static_cast<std::size_t>(height()) * states.size(), 1);
    if (uniform) {
      terrain_.resize(terrain_.size() + states.size(), 1);
    } else {
      terrain_.insert(terrain_.end(), terrain.begin(), terrain.end());
    }
  }
  set_state(occupied_.append_row(), states, CellState::occupied);
  set_state(unknown_.append_row(), states, CellState::unknown);
}

GridMap GridMapBuilder::finish(Frame frame) && {
  assert(height() >= 1);
  Grid<double> terrain;
  if (!terrain_.empty()) terrain = Grid<double>(width(), height(), std::move(terrain_));
  if (frame.y_up) {
    turn_over(occupied_);
    turn_over(unknown_);
    for (int y = 0; y < terrain.height() / 2; ++y) {
      const auto row = terrain.row(y);
      std::swap_ranges(row.begin(), row.end(), terrain.row(terrain.height() - 1 - y).begin());
    }
  }
  return {std::move(occupied_), std::move(unknown_), frame, std::move(terrain)};
}

}  // namespace wend
