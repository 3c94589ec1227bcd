#include "wend/planner/grid/grid_planner.hpp"

#include "wend/map/labelling_time.hpp"
#include "wend/planner/rest_of_path.hpp"
#include "wend/space/grid/grid_path.hpp"
#include "wend/space/grid/line_cost.hpp"

namespace wend {
namespace {

/// That of a query, and a little later: to say that there is no path is worth it.
Deadline deadline_of(const Limits& limits) {
  constexpr double kSecondsToFinish = 0.01;
  return Deadline(limits).later(kSecondsToFinish);
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

bool GridQuery::assign_ends(const FreeSpace& space, const Query& query) {
  if (query.goals.size() != 1 || query.goals.front().tolerance > 0) return false;
  const Point end = query.goals.front().point;
  const auto first = cell_under(space, query.start.point());
  const auto last = cell_under(space, end);
  if (!first || !last || !space.passable(*first) || !space.passable(*last)) return false;
  start = *first;
  start_point = query.start.point();
  goals.clear();
  goals.emplace_back(*last, end);
  return true;
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
  may_be_unreachable_ = query.observer == nullptr && !engine_->expects_a_path() &&
                        !free_space().knows_components() && cells_.assign_ends(free_space(), query);
  if (may_be_unreachable_) return std::nullopt;
  return cells_.assign(free_space(), moves_.adjacency(), query);
}

/// A first query often finds its path before the components would be known: it asks for them only once its search has
/// taken about as long as that. So a query without a path takes at most about twice as long as if it had asked at once.
Status GridPlanner::do_plan(const Query& query, Plan& out) {
  if (!may_be_unreachable_) return plan_by_search(query, out);
  const Deadline deadline = deadline_of(query.limits);
  begin_search(query.limits, nullptr);
  SearchOutcome outcome = SearchOutcome::running;
  const std::uint64_t time_to_ask = labelling_time(free_space().passable());
  while (outcome == SearchOutcome::running && engine_->time_taken() < time_to_ask) {
    outcome = engine_->step();
  }
  if (outcome != SearchOutcome::found && outcome != SearchOutcome::improved) {
    const auto status = unless_connected(deadline);
    if (status && is_limit(*status)) out.metrics = engine_->metrics();
    if (status) return *status;
  }
  return run_on(outcome, query.limits, out);
}

std::optional<Status> GridPlanner::do_begin(const Query& query, Plan& out) {
  if (may_be_unreachable_) {
    if (const auto status = unless_connected(deadline_of(query.limits))) return status;
  }
  return begin_by_search(query, out);
}

/// Why no path can lead to the goal, or why that is not known.
std::optional<Status> GridPlanner::unless_connected(const Deadline& deadline) const {
  const Adjacency adjacency = moves_.adjacency();
  if (!free_space().make_components(adjacency, deadline)) return deadline.status();
  const bool connected =
      free_space().components().connected(cells_.start, cells_.goals.front().any(), adjacency);
  return connected ? std::nullopt : std::optional(Status::unreachable);
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
  } else if (engine_ != nullptr && !change.everything &&
             uniform_ == free_space().uniform_terrain()) {
    engine_->adopt(free_space());
  } else {
    engine_.reset();
    repaired_parts_ = {};  // its memory first
    take(choose_parts_(free_space(), DeadlineCheck::never()));
  }
  return fault("this planner");
}

void GridPlanner::do_release() {
  if (engine_ != nullptr && (engine_.use_count() > 1 || !engine_->release())) engine_.reset();
  another_engine_ = {};
}

void GridPlanner::take(Parts parts) {
  uniform_ = free_space().uniform_terrain();
  moves_ = parts.moves;
  engine_ = std::move(parts.engine);
  bound_ = parts.bound;
  any_angle_ = parts.any_angle;
  another_engine_ = std::move(parts.another);
  repaired_parts_ = std::move(parts.repaired);
}

}  // namespace wend
