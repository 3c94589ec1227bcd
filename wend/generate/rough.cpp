// Rough terrain: smooth hills whose cells cost 2 to 9 on easy ground, and some rocks.

#include <cmath>

#include "wend/generate/block.hpp"
#include "wend/generate/generator_info.hpp"
#include "wend/generate/hills.hpp"

namespace wend {
namespace {

struct RoughOptions {
  double roughness = 0.55;
  double rocks = 0.06;
  std::int64_t hill_size = 24;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"roughness", "proportion of cells that cost more than 1"}, self.roughness, {0, 1});
    field({"rocks", "proportion of blocked cells"}, self.rocks, {0, 1});
    field({"hill_size", "typical distance between hills in cells"}, self.hill_size, {2, 10000});
  }

  MapSize least_size() const { return {3, 3}; }
};

/// The cost: 1 up to the share of easy cells, then 2 to 9 in bands of equal size.
double cost_of_share(double share, double roughness) {
  const double easy = 1 - roughness;
  return share < easy ? 1 : 2 + std::floor(8 * (share - easy) / roughness);
}

Grid<double> terrain_of(MapSize size, const RoughOptions& options, Random& random) {
  const Hills hills(size.width, size.height, static_cast<int>(options.hill_size), random);
  Grid<double> terrain(size.width, size.height, 1);
  if (options.roughness == 0) return terrain;
  for (const Cell cell : every_cell(terrain)) {
    terrain[cell] = std::min(9.0, cost_of_share(hills.share_below(cell), options.roughness));
  }
  return terrain;
}

GridMap generate(MapSize size, const RoughOptions& options, Random& random) {
  Grid<double> terrain = terrain_of(size, options, random);
  const int rock_spacing = std::max(1, static_cast<int>(options.hill_size) / 2);
  const Hills rocks(size.width, size.height, rock_spacing, random);
  Grid<CellState> cells(size.width, size.height, CellState::free);
  for (const Cell cell : every_cell(cells)) {
    if (rocks.share_below(cell) >= 1 - options.rocks) cells[cell] = CellState::occupied;
  }
  for (const Cell corner : {Cell{1, 1}, Cell{size.width - 2, size.height - 2}}) {
    fill(cells, Block{corner.x, corner.y, 1, 1}.grown(1), CellState::free);
  }
  return *make_grid_map(cells, {}, std::move(terrain));
}

}  // namespace

GeneratorInfo rough_generator() {
  GeneratorInfo info = generator_info<RoughOptions>(
      "rough", "hills whose cells cost 2 to 9, with rocks; parts of the map may be disconnected",
      generate);
  info.connected = false;
  return info;
}

}  // namespace wend
