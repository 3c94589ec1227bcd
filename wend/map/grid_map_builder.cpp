#include "wend/map/grid_map_builder.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace wend {
namespace {

/// Appends a row with the cells of one state, 64 at a time.
void append_plane(BitGrid& plane, std::span<const CellState> states, CellState state) {
  const auto words = plane.append_row();
  for (std::size_t x = 0; x < states.size(); ++x) {
    words[(x + 1) / 64] |= std::uint64_t{states[x] == state} << ((x + 1) % 64);
  }
}

void turn_over(BitGrid& plane) {
  for (int y = 0; y < plane.height() / 2; ++y) {
    const auto row = plane.row_words(y);
    std::swap_ranges(row.begin(), row.end(), plane.row_words(plane.height() - 1 - y).begin());
  }
}

}  // namespace

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
  append_plane(occupied_, states, CellState::occupied);
  append_plane(unknown_, states, CellState::unknown);
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
