#pragma once

// MapEdit: what changes on a map: the cells of a box, single cells, or both.
//
//   wend::Grid<wend::CellState> door(3, 1, wend::CellState::occupied);
//   const auto change = space.edit({.corner = {12, 7}, .states = door});
//   if (!change) return report(change.error().message);

#include <optional>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/map/grid.hpp"

namespace wend {

enum class CellState : unsigned char;
class GridMap;

/// A cell as it is to be.
struct CellEdit {
  Cell cell;        // on the map
  CellState state;  // its new state
  std::optional<double> terrain =
      {};  // its new cost of a unit of length, at least 1; nothing: as it is
};

struct MapEdit {
  Cell corner = {};             // the least cell of the box
  Grid<CellState> states = {};  // new states of the box's cells; empty: as they are
  Grid<double> terrain = {};    // new costs of a unit of length, at least 1; empty: as they are
  std::vector<CellEdit> cells = {};  // edited after the box, in this order

  /// The cells of the box.
  WEND_API CellBox box() const;
};

/// Why an edit does not fit a map, if it does not: invalid_map if a cell is not on the map, the states and the
/// terrain of the box differ in size, or a multiplier is not finite or below 1. O(cells of the edit).
WEND_API std::optional<Error> fault_of(const MapEdit& edit, const GridMap& map);

/// A few boxes that contain all these cells: near ones share a box, far ones do not. O(cells * log(cells)).
std::vector<CellBox> boxes_around(std::vector<Cell> cells);

}  // namespace wend
