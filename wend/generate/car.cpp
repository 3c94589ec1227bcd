// A test map for a car: a number of obstacles and of rough cells, placed at random.

#include <algorithm>

#include "wend/generate/generator_info.hpp"

namespace wend {
namespace {

std::int64_t cells_of(MapSize size) { return std::int64_t{size.width} * size.height; }

struct CarOptions {
  std::int64_t obstacles = 25;
  std::int64_t rough = 25;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    constexpr double kMost = double{kMostGeneratedCells} * kMostGeneratedCells;
    field({"obstacles", "number of blocked cells"}, self.obstacles, {0, kMost});
    field({"rough", "number of cells that are rough road, which costs twice as much"}, self.rough,
          {0, kMost});
  }

  MapSize least_size() const { return {1, 1}; }

  /// The number of cells that may change: start and goal, or the only cell, stay free.
  static std::int64_t room(MapSize size) { return std::max<std::int64_t>(cells_of(size) - 2, 0); }

  std::string shortage(MapSize size) const {
    const std::int64_t wanted = obstacles + rough;
    if (wanted <= room(size)) return {};
    return "too small: it needs at least " + std::to_string(wanted + 2) + " cells, for only " +
           std::to_string(room(size)) + " can be obstacles or rough, not " + std::to_string(wanted);
  }
};

/// Draws every choice of cells with the same probability: the next cell is of a kind with the
/// probability (cells of that kind left) / (cells left).
GridMap generate(MapSize size, const CarOptions& options, Random& random) {
  Grid<CellState> cells(size.width, size.height, CellState::free);
  Grid<double> terrain;
  if (options.rough > 0) terrain = {size.width, size.height, 1};
  auto obstacles = static_cast<std::uint64_t>(options.obstacles);
  auto rough = static_cast<std::uint64_t>(options.rough);
  auto left = static_cast<std::uint64_t>(CarOptions::room(size));
  const Cell start{0, 0};
  const Cell goal{size.width - 1, size.height - 1};
  for (const Cell cell : every_cell(cells)) {
    if (cell == start || cell == goal) continue;
    const std::uint64_t drawn = random.below(left--);
    if (drawn < obstacles) {
      cells[cell] = CellState::occupied;
      --obstacles;
    } else if (drawn < obstacles + rough) {
      terrain[cell] = kRoughRoad;
      --rough;
    }
  }
  return *make_grid_map(cells, {}, std::move(terrain));
}

/// The side of the smallest square that holds the default options.
int least_side() {
  int side = 1;
  while (!CarOptions{}.shortage({side, side}).empty()) ++side;
  return side;
}

}  // namespace

GeneratorInfo car_generator() {
  GeneratorInfo info = generator_info<CarOptions>(
      "car", "a yard for a car: obstacles and rough road at random places", generate);
  info.least_width = info.least_height = least_side();
  info.connected = false;
  info.free_corner = 0;
  return info;
}

}  // namespace wend
