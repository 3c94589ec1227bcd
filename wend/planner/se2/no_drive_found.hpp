#pragma once

// NoDriveFound: how the searches of hybrid_astar have ended without a drive.

#include "wend/planner/se2/hybrid_resolution.hpp"

namespace wend {

struct NoDriveFound {
  enum class Why {
    parted,          // not even the largest disc within the robot gets from the start to the goal
    goal_boxed_in,   // the same for the whole robot, as is_enclosed() proves, near the goal
    start_boxed_in,  // the same near the start
    none_found,      // the searches have ended
  };

  Why why = Why::none_found;
  HybridResolution searched;      // the finest at which no pose is left
  bool lattice_searched = false;  // is no pose of the lattice left either?
};

}  // namespace wend
