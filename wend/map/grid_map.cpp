#include "wend/map/grid_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace wend {
namespace {

/// The cells of one state, 64 at a time.
BitGrid plane(const Grid<CellState>& cells, CellState state) {
  BitGrid bits(cells.width(), cells.height());
  for (int y = 0; y < cells.height(); ++y) {
    const auto row = cells.row(y);
    const auto words = bits.row_words(y);
    for (std::size_t x = 0; x < row.size(); ++x) {
      words[(x + 1) / 64] |= std::uint64_t{row[x] == state} << ((x + 1) % 64);
    }
  }
  return bits;
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

}  // namespace wend
