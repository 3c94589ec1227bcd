#pragma once

// Where to plan from and to if the robot cannot stand at the start or the goal: the nearest free cells, and
// the nearest pose.

#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The nearest cell to a blocked one where the robot may stand; if it may stand at `other`, only cells
/// connected to that one count. Nothing if there is none. Complexity as nearest_passable().
WEND_API std::optional<Cell> nearest_free(const FreeSpace& space, Cell cell, Cell other,
                                          Adjacency adjacency);

/// A start and a goal, each moved or not.
struct NearestEnds {
  Cell start;  // where to plan from
  Cell goal;   // where to plan to
};

/// Moves the start and the goal, each if it is on the map and the robot cannot stand there, to the nearest
/// cell that is connected to the other. If both are blocked, one moves to the nearest cell of all and the
/// other follows: whichever order gives the smaller sum of distances. An end stays if there is no such cell.
WEND_API NearestEnds nearest_ends(const FreeSpace& space, Cell start, Cell goal,
                                  Adjacency adjacency);

/// The nearest pose with the same heading at which the robot fits, in grid coordinates: the pose itself, or
/// one in the middle of a cell. For a polygon this is nearer than where every heading fits. Nothing if
/// there is none, or if the pose is NaN or infinite. Complexity as nearest_passable(), times fits().
WEND_API std::optional<Pose> nearest_pose(const FreeSpace& space, const Pose& pose);

}  // namespace wend
