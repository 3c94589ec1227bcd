#pragma once

// edit_between: the edit that makes cells what new values say, where these differ from the old ones. A value may be
// a byte of an occupancy grid or of a costmap; `read` says what it means.
//
//   const std::vector<std::uint8_t> before{0, 0, 0, 0};
//   const std::vector<std::uint8_t> after{0, 254, 0, 0};
//   const auto read = [](std::uint8_t cost) { return wend::meaning_of_cost(cost); };
//   const wend::MapEdit edit =
//       wend::edit_between<std::uint8_t>({before, 2}, {after, 2}, {0, 0}, read);
//   const bool changed = !edit.cells.empty() || !edit.states.empty();

#include <optional>
#include <utility>

#include "wend/map/grid_map.hpp"
#include "wend/map/map_edit.hpp"
#include "wend/map/value_rows.hpp"

namespace wend {

/// What a value says of its cell.
struct CellMeaning {
  CellState state = CellState::free;  // the cell's state
  std::optional<double> terrain =
      1.0;  // its cost of a unit of length, at least 1; nothing: as it is
};

/// The edit from `before` to `after`, values of cells whose least is `corner` on the map. `read(value)` returns a
/// CellMeaning; whether it has a terrain must not depend on the value. Empty if nothing differs. O(values).
template <class Value, class Read>
MapEdit edit_between(const ValueRows<Value>& before, const ValueRows<Value>& after, Cell corner,
                     Read&& read) {
  const Difference found = difference(before, after);
  MapEdit edit;
  if (found.cells == 0) return edit;
  const Cell least = found.box.begin;
  const auto on_map = [&](Cell cell) { return Cell{corner.x + cell.x, corner.y + cell.y}; };
  const auto each = [&](auto&& visit) {
    for (int y = least.y; y < found.box.end.y; ++y) {
      for (int x = least.x; x < found.box.end.x; ++x) visit(Cell{x, y});
    }
  };
  if (found.sparse()) {
    each([&](Cell cell) {
      if (before[cell] == after[cell]) return;
      const CellMeaning meaning = read(after[cell]);
      edit.cells.push_back({on_map(cell), meaning.state, meaning.terrain});
    });
    return edit;
  }
  edit.corner = on_map(least);
  edit.states = {found.box.width(), found.box.height(), CellState::free};
  if (read(after[least]).terrain) edit.terrain = {found.box.width(), found.box.height(), 1.0};
  each([&](Cell cell) {
    const CellMeaning meaning = read(after[cell]);
    const Cell in_box{cell.x - least.x, cell.y - least.y};
    edit.states[in_box] = meaning.state;
    if (!edit.terrain.empty()) edit.terrain[in_box] = meaning.terrain.value_or(1);
  });
  return edit;
}

}  // namespace wend
