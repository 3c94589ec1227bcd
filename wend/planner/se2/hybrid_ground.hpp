#pragma once

// HybridGround: what searches of hybrid_astar share on one FreeSpace: the check of motions, which cells are
// connected, and the coarse grids, which are made when a search first needs them. Threads may share it.

#include <memory>

#include "wend/base/lazy.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/space/se2/coarse_grid.hpp"
#include "wend/space/se2/motion_check.hpp"

namespace wend {

class HybridGround {
 public:
  /// O(cells).
  explicit HybridGround(const FreeSpace& space)
      : check_(space), drivable_(cells_to_drive_in(space)), components_(drivable_) {}

  const MotionCheck& check() const { return check_; }
  const FreeSpace& free_space() const { return check_.free_space(); }

  /// The cells in which the robot's base point can be somewhere.
  const BitGrid& drivable() const { return drivable_; }

  /// Could a way join two cells in which the robot's base point is? If not, none does. O(1).
  bool connected(Cell a, Cell b) const {
    // A base point on the edge of an obstacle may count as in its cell.
    if (!drivable_[a] || !drivable_[b]) return true;
    return components_.connected(a, b, Adjacency::edges);
  }

 private:
  MotionCheck check_;
  BitGrid drivable_;
  ConnectedComponents components_;
};

}  // namespace wend
