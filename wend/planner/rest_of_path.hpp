#pragma once

// What is left of a path that was found before, for a robot that has driven along it: Planner::rest_of() for the kinds
// of path. The rest is legal on the present free space, and its cost is that of now.
//
// A robot that has left the path joins it again ahead, with the planner's own moves, where that is cheapest.

#include <cstddef>
#include <optional>
#include <span>

#include "wend/base/compiler.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// How far, in cells, a robot may be from a path that it still follows: two cells, or 0.3 m if that is more.
WEND_API double farthest_from_path(const Frame& frame);

/// Is a path so cheap that it is taken instead of the rest of the last one? It has to cost less by more than the share
/// `keep` (at least 0) of what the rest costs.
WEND_API bool is_worth_changing_to(double cost, double cost_of_rest, double keep);

/// Of cells joined by steps. `passed` is the index of a cell behind the robot, and becomes that of the nearest one
/// ahead of it. Nothing if there is no legal rest. O(cells log cells).
WEND_API std::optional<Plan> rest_of_steps(const FreeSpace& space, GridMoves moves,
                                           std::span<const Cell> cells, const Query& query,
                                           std::size_t& passed);

/// The same of cells or waypoints joined by lines, as check_any_angle_path() has them.
std::optional<Plan> rest_of_lines(const FreeSpace& space, Adjacency adjacency, const Path& path,
                                  const Query& query, std::size_t& passed);

/// A place on a path of poses.
struct PlaceOnDrive {
  std::size_t joint = 0;  // the pose before it, or at it
  double share = 0;       // of the segment from there on, in [0, 1)
  Pose pose;              // in grid coordinates
  double distance = 0;    // cells, from the pose that was asked about
  double turn = 0;        // radians, not negative: the same for the heading
};

/// The place nearest to a pose, from a joint on, where a radian counts as a cell; of several the first.
PlaceOnDrive nearest_on_drive(const JoinedPoses& drive, const Pose& pose, std::size_t from);

}  // namespace wend
