#include "wend/render/terminal/lattice_cells.hpp"

#include <optional>

#include "wend/render/picture/cell_paints.hpp"

namespace wend {
namespace {

Glyph shade(double multiplier) {
  if (multiplier == 1) return {" ", Meaning::free};
  const double rough = roughness(multiplier);
  return {rough < 1.0 / 3 ? "░" : rough < 2.0 / 3 ? "▒" : "▓", Meaning::rough};
}

Glyph block_glyph(const Scene& scene, Cell block, bool ascii) {
  const FreeSpace& space = scene.space;
  const int unit = scene.unit.value_or(1);
  std::optional<CellRole> role;
  bool unknown = false;
  int too_close = 0;
  double terrain = 0;
  for (int y = unit * block.y; y < unit * (block.y + 1); ++y) {
    for (int x = unit * block.x; x < unit * (block.x + 1); ++x) {
      const CellState state = space.map().state({x, y});
      if (state == CellState::occupied) return {"#", Meaning::yard_obstacle};
      if (const auto of_cell = role_of(scene, {x, y})) role = of_cell;
      unknown = unknown || state == CellState::unknown;
      too_close += space.passable()[{x, y}] ? 0 : 1;
      terrain += space.map().terrain({x, y});
    }
  }
  const int cells = unit * unit;
  if (role) return terrain != cells ? glyph_on_rough_ground(*role) : glyph_of(*role);
  if (unknown) return {"?", Meaning::unknown};
  if (2 * too_close > cells) return {":", Meaning::too_close};
  const double mean = terrain / cells;
  return ascii && mean != 1 ? glyph_of_terrain(mean) : shade(mean);
}

}  // namespace

Grid<Glyph> lattice_cells(const Scene& scene, bool ascii) {
  const Cell size = lattice_size(scene);
  Grid<Glyph> cells(size.x, size.y);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) cells[{x, y}] = block_glyph(scene, {x, y}, ascii);
  }
  return cells;
}

}  // namespace wend
