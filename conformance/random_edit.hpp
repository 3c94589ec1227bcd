#pragma once

// Random edits of maps for tests: boxes of every size, single cells, with and without terrain.

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "conformance/random_map.hpp"
#include "wend/map/map_edit.hpp"

namespace wend::test {

inline CellState random_state(Random& random, double blocked) {
  if (!random.chance(blocked)) return CellState::free;
  return random.chance(0.7) ? CellState::occupied : CellState::unknown;
}

inline double random_multiplier(Random& random) {
  return random.chance(0.5) ? 1 : one_of<double>(random, std::array{1.0, 1.25, 2.0, 3.7, 9.0});
}

inline CellBox random_box_on(Random& random, const GridMap& map, int most) {
  const Cell corner = random_cell(random, map.width(), map.height());
  const int right = std::min(map.width(), corner.x + most);
  const int top = std::min(map.height(), corner.y + most);
  const int end_x = random.between(corner.x + 1, right);
  const int end_y = random.between(corner.y + 1, top);
  return {corner, {end_x, end_y}};
}

/// An edit that fits the map. Some change nothing.
inline MapEdit random_edit(Random& random, const GridMap& map, bool terrain) {
  MapEdit edit;
  const auto blocked = one_of<double>(random, std::array{0.0, 0.2, 0.5, 1.0});
  if (random.chance(0.6)) {
    const CellBox box = random_box_on(random, map, random.chance(0.3) ? 80 : 6);
    edit.corner = box.begin;
    const bool only_terrain = terrain && random.chance(0.2);
    if (!only_terrain) edit.states = Grid<CellState>(box.width(), box.height());
    if (only_terrain || (terrain && random.chance(0.5))) {
      edit.terrain = Grid<double>(box.width(), box.height(), 1);
    }
    const bool flat = random.chance(0.3);
    for (const Cell cell : CellRange(box.width(), box.height())) {
      if (!edit.states.empty()) edit.states[cell] = random_state(random, blocked);
      if (!edit.terrain.empty() && !flat) edit.terrain[cell] = random_multiplier(random);
    }
  }
  for (int count = random.chance(0.5) ? random.between(0, 5) : 0; count > 0; --count) {
    CellEdit each{random_cell(random, map.width(), map.height()), random_state(random, blocked)};
    if (terrain && random.chance(0.5)) each.terrain = random_multiplier(random);
    edit.cells.push_back(each);
  }
  return edit;
}

/// The map with the edit, made cell by cell.
inline GridMap edited_by_hand(const GridMap& map, const MapEdit& edit) {
  Grid<CellState> states(map.width(), map.height());
  Grid<double> terrain(map.width(), map.height(), 1);
  const CellBox box = edit.box();
  for (const Cell cell : every_cell(map)) {
    const Cell in_box{cell.x - box.begin.x, cell.y - box.begin.y};
    const bool inside = box.contains(cell);
    states[cell] = inside && !edit.states.empty() ? edit.states[in_box] : map.state(cell);
    terrain[cell] = inside && !edit.terrain.empty() ? edit.terrain[in_box] : map.terrain(cell);
  }
  for (const CellEdit& each : edit.cells) {
    states[each.cell] = each.state;
    if (each.terrain) terrain[each.cell] = *each.terrain;
  }
  return *make_grid_map(states, map.frame(), std::move(terrain));
}

}  // namespace wend::test
