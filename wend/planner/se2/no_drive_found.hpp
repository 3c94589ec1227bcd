#pragma once

// NoDriveFound: how the searches of hybrid_astar have ended without a drive.

#include "wend/planner/se2/hybrid_resolution.hpp"

namespace wend {

struct NoDriveFound {
  enum class Why {
    parted,          // not even the largest disc within the robot gets from the start to the goal
    goal_boxed_in,   // few poses lead to the goal, and the start is none of them
    start_boxed_in,  // the start leads to few poses, and the goal is none of them
    none_found,      // the searches have driven everywhere
  };

  Why why = Why::none_found;
  HybridResolution searched;      // the finest at which no pose is left
  bool lattice_searched = false;  // is no pose of the lattice left either?
};

}  // namespace wend
