#include "wend/planner/grid/grid_planner.hpp"

#include "wend/base/parse.hpp"
#include "wend/map/place_text.hpp"
#include "wend/planner/rest_of_path.hpp"
#include "wend/space/grid/grid_path.hpp"
#include "wend/space/grid/line_cost.hpp"

namespace wend {
namespace {

std::string text_of(Point point) {
  return '(' + format_number(point.x) + ',' + format_number(point.y) + ')';
}

/// "the start, cell (3,4), is an obstacle"; on a map in metres "the start (0.35,0.45) m, cell (3,4), is an obstacle".
std::string end_in_cells(const FreeSpace& space, const std::string& name, Point point) {
  const auto cell = cell_under(space, point);
  const Frame& frame = space.map().frame();
  if (!cell && frame.metric) {
    return "the " + name + " " + metres_text(frame.to_metres(point)) +
           " is outside the map, which covers " +
           covered_metres(frame, space.width(), space.height());
  }
  if (!cell) {
    return "the " + name + " " + text_of(point) + " is outside the map of " +
           std::to_string(space.width()) + " x " + std::to_string(space.height()) + " cells";
  }
  const std::string text =
      "the " + name + (frame.metric ? ' ' + metres_text(frame.to_metres(centre_of(*cell))) : "") +
      ", cell " + cell_text(*cell);
  const auto blocked = space.why_blocked(*cell);
  return blocked ? text + ", is " + std::string(describe(*blocked)) : text;
}

}  // namespace

std::optional<Status> GridQuery::assign(const FreeSpace& space, Adjacency adjacency,
                                        const Query& query) {
  const auto start_cell = cell_under(space, query.start.point());
  if (!start_cell) return Status::start_outside;
  if (!space.passable(*start_cell)) return Status::start_blocked;
  start = *start_cell;
  start_point = query.start.point();
  goals.clear();
  std::optional<Status> why_none;  // of the first goal
  for (const Goal& goal : query.goals) {
    const auto cell_of_goal = cell_under(space, goal.point);
    // The usual goal takes a fraction of the work; a query by an index is short enough to notice.
    if (goal.tolerance == 0 && cell_of_goal &&
        space.components().connected(start, *cell_of_goal, adjacency)) {
      goals.emplace_back(*cell_of_goal, goal.point);
      continue;
    }
    GoalRegion region(goal, cell_of_goal, cells_of(space));
    Status why = region.empty() ? Status::goal_outside : Status::goal_blocked;
    const bool reachable = region.keep_if([&](Cell cell) {
      if (space.passable(cell)) why = Status::unreachable;
      return space.components().connected(start, cell, adjacency);
    });
    if (reachable) {
      goals.push_back(region);
    } else if (!why_none) {
      why_none = why;
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
      return "there is no path from " + end_in_cells(space, "start", query.start.point()) +
             ", to " + end_in_cells(space, "goal", query.goals.front().point);
    default:
      return {};
  }
}

GridPlanner::GridPlanner(FreeSpace space, PartsChooser choose_parts, DeadlineCheck& stop)
    : SearchPlanner(std::move(space)), choose_parts_(std::move(choose_parts)) {
  take(choose_parts_(free_space(), stop));
}

GridPlanner::GridPlanner(FreeSpace space, PartsChooser choose_parts, Parts parts)
    : SearchPlanner(std::move(space)), choose_parts_(std::move(choose_parts)) {
  take(std::move(parts));
}

std::optional<Error> GridPlanner::fault(std::string_view name) const {
  if (engine_ == nullptr) {
    if (auto refused = refused_terrain(name, free_space())) return refused;
  }
  if (allocated()) return std::nullopt;
  return Error{Status::memory_limit, "no memory for the nodes of " +
                                         std::to_string(free_space().map().size()) + " cells"};
}

std::optional<Status> GridPlanner::do_check(const Query& query) {
  if (engine_ == nullptr) return Status::unsupported_map;
  return cells_.assign(free_space(), moves_.adjacency(), query);
}

void GridPlanner::begin_search(const Limits& limits, SearchObserver* observer) {
  engine_->set_start_point(cells_.start_point);
  engine_->begin(cells_.start, cells_.goals, limits, observer);
}

void GridPlanner::assess(Plan& out) {
  const auto cells = out.path.cells();
  out.cost = !any_angle_                      ? grid_path_cost(free_space(), cells)
             : free_space().uniform_terrain() ? out.path.length()
                                              : any_angle_path_cost(free_space(), cells);
  out.bound = engine_->bound().value_or(bound_);
}

std::string GridPlanner::do_reason(const Query& query, Status status) const {
  return reason_in_cells(free_space(), query, status);
}

double GridPlanner::do_heuristic(const Pose& pose) const {
  const auto cell = cell_under(free_space(), pose.point());
  return cell && engine_ != nullptr ? engine_->heuristic(*cell) : 0;
}

std::optional<Plan> GridPlanner::do_rest_of(const Path& path, const Query& query,
                                            std::size_t& passed) const {
  if (engine_ == nullptr) return std::nullopt;
  if (any_angle_) return rest_of_lines(free_space(), moves_.adjacency(), path, query, passed);
  return rest_of_steps(free_space(), moves_, path.cells(), query, passed);
}

std::unique_ptr<Planner> GridPlanner::do_clone() const {
  Parts parts = another_engine_ ? Parts{moves_,     another_engine_(), bound_,
                                        any_angle_, another_engine_,   repaired_parts_}
                                : choose_parts_(free_space(), DeadlineCheck::never());
  return std::unique_ptr<Planner>(new GridPlanner(free_space(), choose_parts_, std::move(parts)));
}

std::optional<Error> GridPlanner::do_update(const SpaceChange& change) {
  do_release();
  if (repaired_parts_ && !change.everything) {
    take(repaired_parts_(free_space(), change));
  } else {
    repaired_parts_ = {};  // its memory first
    take(choose_parts_(free_space(), DeadlineCheck::never()));
  }
  return fault("this planner");
}

void GridPlanner::do_release() {
  engine_.reset();
  another_engine_ = {};
}

void GridPlanner::take(Parts parts) {
  moves_ = parts.moves;
  engine_ = std::move(parts.engine);
  bound_ = parts.bound;
  any_angle_ = parts.any_angle;
  another_engine_ = std::move(parts.another);
  repaired_parts_ = std::move(parts.repaired);
}

}  // namespace wend
