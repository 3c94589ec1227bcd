#include "wend/planner/grid_planner.hpp"

#include <cmath>
#include <limits>

#include "wend/planner/search_status.hpp"
#include "wend/space/grid_path.hpp"

namespace wend {
namespace {

/// The cell that a pose lies in, if it is on the map.
std::optional<Cell> cell_on_map(const FreeSpace& space, const Pose& pose) {
  const bool inside = pose.x >= 0 && pose.y >= 0 && pose.x < space.width() &&
                      pose.y < space.height();  // false for NaN
  if (!inside) return std::nullopt;
  return Cell{static_cast<int>(pose.x), static_cast<int>(pose.y)};
}

}  // namespace

std::optional<Status> GridQuery::assign(const FreeSpace& space, Adjacency adjacency,
                                        const Query& query) {
  const auto start_cell = cell_on_map(space, query.start);
  if (!start_cell) return Status::start_outside;
  if (!space.passable(*start_cell)) return Status::start_blocked;
  start = *start_cell;
  goals.clear();
  std::optional<Status> why_none;  // of the first goal
  for (const Pose& pose : query.goals) {
    const auto goal = cell_on_map(space, pose);
    if (goal && space.regions().connected(start, *goal, adjacency)) {
      goals.push_back(*goal);
    } else if (!why_none) {
      why_none = !goal                    ? Status::goal_outside
                 : !space.passable(*goal) ? Status::goal_blocked
                                          : Status::unreachable;
    }
  }
  if (goals.empty()) return why_none;
  return std::nullopt;
}

GridPlanner::GridPlanner(FreeSpace space, PartsChooser choose_parts)
    : Planner(std::move(space)),
      choose_parts_(std::move(choose_parts)),
      parts_(choose_parts_(free_space())) {}

std::optional<Status> GridPlanner::do_check(const Query& query) {
  return cells_.assign(free_space(), parts_.moves.adjacency(), query);
}

Status GridPlanner::do_plan(const Query& query, Plan& out) {
  parts_.engine->begin(cells_.start, cells_.goals, query.limits, query.observer);
  return finish(parts_.engine->run(), out);
}

std::optional<Status> GridPlanner::do_begin(const Query& query, Plan& out) {
  limits_ = query.limits;
  parts_.engine->begin(cells_.start, cells_.goals, limits_, query.observer);
  out.metrics = parts_.engine->metrics();
  return std::nullopt;
}

std::optional<Status> GridPlanner::do_step(Plan& out) {
  const SearchOutcome outcome = parts_.engine->step();
  out.metrics = parts_.engine->metrics();
  if (outcome == SearchOutcome::running) return std::nullopt;
  return finish(outcome, out);
}

Status GridPlanner::finish(SearchOutcome outcome, Plan& out) const {
  out.metrics = parts_.engine->metrics();
  if (outcome != SearchOutcome::found) return status_of(outcome);
  parts_.engine->write_path(out.path);
  out.cost = grid_path_cost(free_space(), out.path.cells());
  out.bound = parts_.bound;
  return Status::found;
}

double GridPlanner::do_heuristic(Cell cell) const { return parts_.engine->heuristic(cell); }

void GridPlanner::do_update(std::span<const Cell> /*changed*/) {
  parts_.engine.reset();  // its memory first
  parts_ = choose_parts_(free_space());
}

}  // namespace wend
