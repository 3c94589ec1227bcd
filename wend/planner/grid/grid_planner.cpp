#include "wend/planner/grid/grid_planner.hpp"

#include <cmath>
#include <limits>

#include "wend/base/parse.hpp"
#include "wend/planner/search_status.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

/// The cell that a pose lies in, if it is on the map.
std::optional<Cell> cell_on_map(const FreeSpace& space, Point point) {
  const bool inside = point.x >= 0 && point.y >= 0 && point.x < space.width() &&
                      point.y < space.height();  // false for NaN
  if (!inside) return std::nullopt;
  return Cell{static_cast<int>(point.x), static_cast<int>(point.y)};
}

std::string text_of(Point point) {
  return '(' + format_number(point.x) + ',' + format_number(point.y) + ')';
}

/// "the start, cell (3,4), is an obstacle"
std::string end_in_cells(const FreeSpace& space, const std::string& name, Point point) {
  const auto cell = cell_on_map(space, point);
  if (!cell) {
    return "the " + name + " " + text_of(point) + " is outside the map of " +
           std::to_string(space.width()) + " x " + std::to_string(space.height()) + " cells";
  }
  const std::string text =
      "the " + name + ", cell (" + std::to_string(cell->x) + ',' + std::to_string(cell->y) + ")";
  const auto blocked = space.why_blocked(*cell);
  return blocked ? text + ", is " + std::string(describe(*blocked)) : text;
}

}  // namespace

std::optional<Status> GridQuery::assign(const FreeSpace& space, Adjacency adjacency,
                                        const Query& query) {
  const auto start_cell = cell_on_map(space, query.start.point());
  if (!start_cell) return Status::start_outside;
  if (!space.passable(*start_cell)) return Status::start_blocked;
  start = *start_cell;
  goals.clear();
  std::optional<Status> why_none;  // of the first goal
  for (const Goal& typed : query.goals) {
    const auto goal = cell_on_map(space, typed.point);
    if (goal && space.components().connected(start, *goal, adjacency)) {
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

std::string reason_in_cells(const FreeSpace& space, const Query& query, Status status) {
  switch (status) {
    case Status::start_outside:
    case Status::start_blocked:
      return end_in_cells(space, "start", query.start.point());
    case Status::goal_outside:
    case Status::goal_blocked:
      return end_in_cells(space, "goal", query.goals.front().point);
    case Status::unreachable:
      return "there is no path from " + end_in_cells(space, "start", query.start.point()) + ", to " +
             end_in_cells(space, "goal", query.goals.front().point);
    default:
      return {};
  }
}

GridPlanner::GridPlanner(FreeSpace space, PartsChooser choose_parts)
    : Planner(std::move(space)),
      choose_parts_(std::move(choose_parts)),
      parts_(choose_parts_(free_space())) {}

std::optional<Status> GridPlanner::do_check(const Query& query) {
  if (parts_.engine == nullptr) return Status::unsupported_map;
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

OpenList GridPlanner::do_open_list(std::size_t most) const {
  return parts_.engine == nullptr ? OpenList{} : parts_.engine->open_list(most);
}

std::string GridPlanner::do_reason(const Query& query, Status status) const {
  return reason_in_cells(free_space(), query, status);
}

double GridPlanner::do_heuristic(const Pose& pose) const {
  const auto cell = cell_on_map(free_space(), pose.point());
  return cell && parts_.engine != nullptr ? parts_.engine->heuristic(*cell) : 0;
}

void GridPlanner::do_update(std::span<const Cell> /*changed*/) {
  parts_.engine.reset();  // its memory first
  parts_ = choose_parts_(free_space());
}

}  // namespace wend
