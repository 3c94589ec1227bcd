#include <algorithm>
#include <span>

#include "wend/map/grid_map.hpp"

namespace wend {
namespace {

/// Joins cells [begin, end) of a row to a box.
CellBox joined_with_row(const CellBox& box, int y, int begin, int end) {
  return box.joined_with({{begin, y}, {end, y + 1}});
}

}  // namespace

void GridMap::set_terrain(Data& data, Cell cell, double multiplier) {
  if (data.terrain.empty()) {
    if (multiplier == 1) return;
    data.terrain = Grid<double>(data.occupied.width(), data.occupied.height(), 1);
  }
  double& terrain = data.terrain[cell];
  data.dear_cells += (multiplier != 1 ? 1U : 0U) - (terrain != 1 ? std::size_t{1} : 0);
  terrain = multiplier;
}

/// Returns the least box of the cells that changed.
CellBox GridMap::edit_box(Data& data, const MapEdit& edit) {
  const CellBox box = edit.box();
  CellBox changed;
  for (int y = 0; y < box.height(); ++y) {
    const int row = box.begin.y + y;
    const auto assign = [&](BitGrid& plane, CellState state) {
      const auto states = edit.states.row(y);
      const auto [before, behind] = assign_row(plane.row_words(row), box.begin.x, states,
                                               [state](CellState here) { return here == state; });
      if (before == states.size()) return;
      changed = joined_with_row(changed, row, box.begin.x + static_cast<int>(before),
                                box.end.x - static_cast<int>(behind));
    };
    if (!edit.states.empty()) {
      assign(data.occupied, CellState::occupied);
      assign(data.unknown, CellState::unknown);
    }
    for (int x = 0; !edit.terrain.empty() && x < box.width(); ++x) {
      const Cell cell{box.begin.x + x, row};
      const double multiplier = edit.terrain[{x, y}];
      if (multiplier == (data.terrain.empty() ? 1 : data.terrain[cell])) continue;
      set_terrain(data, cell, multiplier);
      changed = joined_with_row(changed, row, cell.x, cell.x + 1);
    }
  }
  return changed;
}

/// Returns the cells that changed.
std::vector<Cell> GridMap::edit_cells(Data& data, const std::vector<CellEdit>& cells) {
  std::vector<Cell> changed;
  for (const CellEdit& each : cells) {
    const Cell cell = each.cell;
    const double before = data.terrain.empty() ? 1 : data.terrain[cell];
    const double terrain = each.terrain.value_or(before);
    const bool occupied = each.state == CellState::occupied;
    const bool unknown = each.state == CellState::unknown;
    if (data.occupied[cell] == occupied && data.unknown[cell] == unknown && terrain == before) {
      continue;
    }
    data.occupied.set(cell, occupied);
    data.unknown.set(cell, unknown);
    if (terrain != before) set_terrain(data, cell, terrain);
    changed.push_back(cell);
  }
  return changed;
}

/// What an edit says of a cell is no mask's word.
void GridMap::forget_zones(Data& data, const MapEdit& edit) {
  const CellBox box = edit.box();
  for (MapZone& zone : data.zones) {
    for (const Cell cell : every_cell(edit.states)) {
      zone.cells.set({box.begin.x + cell.x, box.begin.y + cell.y}, false);
    }
    for (const CellEdit& each : edit.cells) zone.cells.set(each.cell, false);
  }
}

Expected<std::vector<CellBox>, Error> GridMap::edit(const MapEdit& edit) {
  if (auto fault = fault_of(edit, *this)) return Unexpected<Error>(*std::move(fault));
  Data& data = data_.change();
  forget_zones(data, edit);
  const CellBox box = edit_box(data, edit);
  std::vector<CellBox> boxes = boxes_around(edit_cells(data, edit.cells));
  if (!box.empty()) boxes.push_back(box);
  if (data.dear_cells == 0) data.terrain = {};
  return boxes;
}

}  // namespace wend
