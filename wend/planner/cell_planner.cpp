#include "wend/planner/cell_planner.hpp"

#include <algorithm>
#include <utility>

#include "wend/planner/grid/grid_planner.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {

CellSearch::CellSearch(Cell start, std::span<const Cell> goals, const Query& query)
    : start_(start), goals_(goals), observer_(query.observer) {
  limits_.begin(query.limits);
}

bool CellSearch::is_goal(Cell cell) const {
  return std::find(goals_.begin(), goals_.end(), cell) != goals_.end();
}

void CellSearch::generate(Cell cell, std::optional<Cell> parent, double g) {
  ++metrics_.generated;
  metrics_.max_frontier = std::max(metrics_.max_frontier, metrics_.generated - metrics_.expanded);
  if (observer_ != nullptr) observer_->on_generate({cell, parent, g, 0, g});
}

bool CellSearch::expand(Cell cell, std::optional<Cell> parent, double g) {
  if (limits_.due(metrics_.expanded)) {
    outcome_ = limits_.look(metrics_.expanded);
    if (outcome_ != SearchOutcome::running) return false;
  }
  ++metrics_.expanded;
  if (observer_ != nullptr) observer_->on_expand({cell, parent, g, 0, g});
  return true;
}

CellPlanner::CellPlanner(FreeSpace space, GridMoves moves, double bound)
    : Planner(std::move(space)), moves_(moves), bound_(bound) {}

std::optional<Status> CellPlanner::do_check(const Query& query) {
  GridQuery cells{{}, std::move(goals_)};  // keeps the memory
  const auto refused = cells.assign(free_space(), moves_.adjacency(), query);
  start_ = cells.start;
  goals_ = std::move(cells.goals);
  return refused;
}

Status CellPlanner::do_plan(const Query& query, Plan& out) {
  CellSearch task(start_, goals_, query);
  const SearchOutcome outcome = search(task, out.path);
  out.metrics = task.metrics();
  if (outcome != SearchOutcome::found) {
    out.path.clear();
    return status_of(outcome);
  }
  out.cost = grid_path_cost(free_space(), out.path.cells());
  out.bound = bound_;
  return Status::found;
}

std::string CellPlanner::do_reason(const Query& query, Status status) const {
  return reason_in_cells(free_space(), query, status);
}

std::optional<Error> CellPlanner::do_update(std::span<const Cell> /*changed*/) {
  return std::nullopt;
}

}  // namespace wend
