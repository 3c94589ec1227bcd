// Random obstacles: every cell is blocked with the same probability.

#include "wend/generate/generator_info.hpp"

namespace wend {
namespace {

struct RandomMapOptions {
  double density = 0.2;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"density", "proportion of blocked cells"}, self.density, {0, 1});
  }

  MapSize least_size() const { return {1, 1}; }
};

GridMap generate(MapSize size, const RandomMapOptions& options, Random& random) {
  Grid<CellState> cells(size.width, size.height, CellState::free);
  for (const Cell cell : every_cell(cells)) {
    if (random.chance(options.density)) cells[cell] = CellState::occupied;
  }
  for (const Cell corner : {Cell{1, 1}, Cell{size.width - 2, size.height - 2}}) {
    if (cells.contains(corner)) cells[corner] = CellState::free;
  }
  return *make_grid_map(cells);
}

}  // namespace

GeneratorInfo random_generator() {
  GeneratorInfo info = generator_info<RandomMapOptions>(
      "random", "obstacles at random places; parts of the map may be disconnected", generate);
  info.connected = false;
  return info;
}

}  // namespace wend
