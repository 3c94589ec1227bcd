#pragma once

// SpaceChange: what may differ between two free spaces of one robot, before and after an edit of the map.
// Planners read it to repair what they have prepared instead of preparing it again: Planner::update().
//
// A change that names boxes says that both spaces have the same size, robot and policies, and that outside
// of the boxes every cell is as it was: whether it is blocked, passable or possible, its cost, and its clearance
// as far as the robot needs it. An unknown cell may have become known to be what it was taken for.

#include <vector>

#include "wend/geometry/cell_box.hpp"

namespace wend {

struct SpaceChange {
  bool everything = false;     // any cell may differ, and the size and the robot may too
  std::vector<CellBox> boxes;  // else the cells that may differ; boxes may overlap, none is empty

  /// Nothing is known to be as it was.
  static SpaceChange of_everything() { return {true, {}}; }

  /// Is every cell as it was?
  bool none() const { return !everything && boxes.empty(); }

  friend bool operator==(const SpaceChange&, const SpaceChange&) = default;
};

}  // namespace wend
