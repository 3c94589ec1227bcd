#include "cli/arguments/nearest_ends.hpp"

#include <fmt/format.h>

#include <optional>

#include "wend/geometry/pose.hpp"
#include "wend/map/nearest_passable.hpp"

namespace wend::cli {
namespace {

struct Pair {
  Cell first;
  Cell second;
};

double apart(Cell a, Cell b) { return distance(centre_of(a), centre_of(b)); }

/// `first` moved to the nearest cell of all, then `second` to the nearest one connected to that.
std::optional<Pair> nearest_pair(const FreeSpace& space, Cell first, Cell second,
                                 Adjacency adjacency) {
  const auto near_first = nearest_passable(space, first);
  if (!near_first) return std::nullopt;
  const auto near_second = nearest_passable(space, second, near_first, adjacency);
  if (!near_second) return std::nullopt;
  return Pair{*near_first, *near_second};
}

/// Both ends moved, by the smaller sum of distances of the two ways to do it.
std::optional<Pair> nearest_ends(const FreeSpace& space, Cell start, Cell goal,
                                 Adjacency adjacency) {
  const auto from_start = nearest_pair(space, start, goal, adjacency);
  const auto from_goal = nearest_pair(space, goal, start, adjacency);
  if (!from_start || !from_goal) return std::nullopt;
  const double start_first = apart(start, from_start->first) + apart(goal, from_start->second);
  const double goal_first = apart(goal, from_goal->first) + apart(start, from_goal->second);
  if (start_first <= goal_first) return from_start;
  return Pair{from_goal->second, from_goal->first};
}

/// Is there a cell to move away from? Outside the map there is none.
bool is_blocked(const FreeSpace& space, Cell cell) {
  return space.contains(cell) && !space.passable(cell);
}

}  // namespace

std::vector<std::string> move_to_nearest(Ends& ends, const FreeSpace& space,
                                         const Coordinates& coordinates, GridMoves moves) {
  std::vector<std::string> notes;
  const Explainer explainer(space, coordinates, moves);
  const Adjacency adjacency = moves.adjacency();
  const auto move = [&](Place& place, std::optional<Cell> cell, std::string_view preposition) {
    if (!cell || *cell == place.cell) return;
    notes.push_back(fmt::format("{}; planning {} {}, {} away", explainer.blocked(place),
                                preposition, coordinates.text(*cell),
                                coordinates.length(apart(place.cell, *cell))));
    place.cell = *cell;
    place.text = coordinates.text(*cell);
  };
  const bool start_blocked = is_blocked(space, ends.start.cell);
  const bool goal_blocked = is_blocked(space, ends.goal.cell);
  if (start_blocked && goal_blocked) {
    const auto pair = nearest_ends(space, ends.start.cell, ends.goal.cell, adjacency);
    if (!pair) return notes;
    move(ends.start, pair->first, "from");
    move(ends.goal, pair->second, "to");
  } else if (start_blocked && space.passable(ends.goal.cell)) {
    move(ends.start, nearest_passable(space, ends.start.cell, ends.goal.cell, adjacency), "from");
  } else if (goal_blocked && space.passable(ends.start.cell)) {
    move(ends.goal, nearest_passable(space, ends.goal.cell, ends.start.cell, adjacency), "to");
  }
  return notes;
}

}  // namespace wend::cli
