#include "wend/session/nearest_ends.hpp"

#include <cmath>

#include "wend/robot/nearest_passable.hpp"

namespace wend {
namespace {

double apart(Cell a, Cell b) { return distance(centre_of(a), centre_of(b)); }

/// Is it a cell of the map that the robot cannot stand on?
bool is_blocked(const FreeSpace& space, Cell cell) {
  return space.contains(cell) && !space.passable(cell);
}

struct CellPair {
  Cell first;
  Cell second;
};

/// `first` moved to the nearest cell of all, then `second` to the nearest one connected to that.
std::optional<CellPair> nearest_pair(const FreeSpace& space, Cell first, Cell second,
                                     Adjacency adjacency) {
  const auto near_first = nearest_passable(space, first);
  if (!near_first) return std::nullopt;
  const auto near_second = nearest_passable(space, second, near_first, adjacency);
  if (!near_second) return std::nullopt;
  return CellPair{*near_first, *near_second};
}

/// Moves both, in the order that gives the smaller sum of distances.
NearestEnds both_moved(const FreeSpace& space, Cell start, Cell goal, Adjacency adjacency) {
  const auto from_start = nearest_pair(space, start, goal, adjacency);
  const auto from_goal = nearest_pair(space, goal, start, adjacency);
  if (!from_start || !from_goal) return {start, goal};
  const double start_first = apart(start, from_start->first) + apart(goal, from_start->second);
  const double goal_first = apart(goal, from_goal->first) + apart(start, from_goal->second);
  if (start_first <= goal_first) return {from_start->first, from_start->second};
  return {from_goal->second, from_goal->first};
}

}  // namespace

std::optional<Cell> nearest_free(const FreeSpace& space, Cell cell, Cell other,
                                 Adjacency adjacency) {
  if (!space.passable(other)) return nearest_passable(space, cell);
  return nearest_passable(space, cell, other, adjacency);
}

NearestEnds nearest_ends(const FreeSpace& space, Cell start, Cell goal, Adjacency adjacency) {
  const bool start_blocked = is_blocked(space, start);
  const bool goal_blocked = is_blocked(space, goal);
  if (start_blocked && goal_blocked) return both_moved(space, start, goal, adjacency);
  if (start_blocked && space.passable(goal)) {
    return {nearest_passable(space, start, goal, adjacency).value_or(start), goal};
  }
  if (goal_blocked && space.passable(start)) {
    return {start, nearest_passable(space, goal, start, adjacency).value_or(goal)};
  }
  return {start, goal};
}

std::optional<Pose> nearest_pose(const FreeSpace& space, const Pose& pose) {
  constexpr double kMost = 1e9;  // what a Cell can hold, with room
  if (!(std::abs(pose.x) < kMost && std::abs(pose.y) < kMost) || !std::isfinite(pose.heading)) {
    return std::nullopt;
  }
  if (space.fits(pose)) return pose;
  const auto fits = [&](Cell cell) { return space.fits(pose_at(cell, pose.heading)); };
  const auto cell = nearest_accepted(space.width(), space.height(), cell_at(pose.point()), fits);
  if (!cell) return std::nullopt;
  return pose_at(*cell, pose.heading);
}

}  // namespace wend
