#include "wend/planner/failure.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/arc_distance.hpp"
#include "wend/geometry/box.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/planner/failure_causes.hpp"
#include "wend/robot/sweep/sweep.hpp"
#include "wend/robot/zone_name.hpp"

namespace wend {
namespace {

double longest_distance(const Polygon& outline) {
  double most = 0;
  for (const Point a : outline.corners()) most = std::max(most, farthest_distance(outline, a));
  return most;
}

std::optional<RobotTooLarge> size_if_too_large(const FreeSpace& space) {
  if (space.outside() == OutsidePolicy::free) return std::nullopt;
  const double inner = space.footprint().inner_disc().radius / space.map().frame().resolution;
  const Polygon* const outline = space.outline();
  const bool too_large = 2 * inner > std::min(space.width(), space.height()) ||
                         (outline != nullptr &&
                          longest_distance(*outline) > hypotenuse(space.width(), space.height()));
  if (!too_large) return std::nullopt;
  if (outline == nullptr) {
    return RobotTooLarge{2 * space.radius_in_cells(), 2 * space.radius_in_cells()};
  }
  Box box(outline->corners().front());
  for (const Point corner : outline->corners()) box.include(corner);
  return RobotTooLarge{box.high.x - box.low.x, box.high.y - box.low.y};
}

/// Is an obstacle of this kind too near to the middle of a cell for the robot's disc?
template <class Kind>
bool any_too_near(const FreeSpace& space, Cell cell, Kind is_of_kind) {
  const Point centre = centre_of(cell);
  const Box near = Box(centre).grown_by(space.radius_in_cells());
  return any_obstacle(space, near, [&](Cell square) {
    const double away = distance(centre, square);
    return !space.far_enough(4 * away * away) && is_of_kind(square);
  });
}

/// The mask whose cells are too near for the robot's disc, if no obstacle is.
std::optional<std::string> mask_near(const FreeSpace& space, Cell cell) {
  std::optional<std::string> mask;
  const bool obstacle = any_too_near(space, cell, [&](Cell square) {
    const auto name = mask_at(space, square);
    if (name) mask = name;
    return !name;
  });
  return obstacle ? std::nullopt : mask;
}

FailureCause cause_of(const FreeSpace& space, EndIndex end, Cell cell, BlockReason reason) {
  if (reason == BlockReason::outside) return EndOutside{end};
  if (const auto size = size_if_too_large(space)) return *size;
  EndBlocked blocked{.end = end, .reason = reason, .cell = cell, .radius = space.radius_in_cells()};
  if (reason == BlockReason::obstacle) blocked.mask = mask_at(space, cell);
  if (reason == BlockReason::too_close || reason == BlockReason::over_edge) {
    blocked.distance = space.clearance(cell);
    if (reason == BlockReason::too_close) blocked.mask = mask_near(space, cell);
  }
  if (reason == BlockReason::over_edge) {
    blocked.fits_beyond_edge = !any_too_near(space, cell, [](Cell) { return true; });
  }
  return blocked;
}

bool has_tolerances(const Goal& goal) {
  return goal.tolerance >= 0 && goal.heading_tolerance >= 0;  // neither is NaN
}

QueryEnd end_in_cell(Point point) { return {point, point}; }

std::optional<FailureCause> cause_in_cell(const FreeSpace& space, EndIndex end, Point point) {
  const auto cell = cell_under(space, point);
  return cell ? why_blocked(space, end, *cell) : EndOutside{end};
}

}  // namespace

std::optional<FailureCause> why_blocked(const FreeSpace& space, EndIndex end, Cell cell) {
  const auto reason = space.why_blocked(cell);
  if (!reason) return std::nullopt;
  return cause_of(space, end, cell, *reason);
}

std::optional<FailureCause> why_blocked(const FreeSpace& space, EndIndex end, const Pose& pose) {
  const auto reason = space.why_blocked(pose);
  if (!reason) return std::nullopt;
  if (*reason == BlockReason::outside) return EndOutside{end};
  FailureCause cause = cause_of(space, end, cell_at(pose.point()), *reason);
  if (auto* const blocked = std::get_if<EndBlocked>(&cause)) {
    blocked->contact = *reason == BlockReason::overlaps || *reason == BlockReason::leaves
                           ? contact_at(space, pose)
                           : std::nullopt;
  }
  return cause;
}

std::vector<FailureCause> causes_in_cells(const FreeSpace& space, const Query& query,
                                          Status status) {
  std::vector<FailureCause> causes;
  if (status == Status::start_outside || status == Status::start_blocked) {
    if (auto cause = cause_in_cell(space, {}, query.start.point())) causes.push_back(*cause);
  }
  if (status != Status::goal_outside && status != Status::goal_blocked &&
      status != Status::unreachable) {
    return causes;
  }
  for (std::size_t i = 0; i < query.goals.size(); ++i) {
    const Goal& goal = query.goals[i];
    // The point itself may be blocked where another cell within the tolerance is not.
    const bool separated =
        status == Status::unreachable && (query.goals.size() == 1 || goal.tolerance > 0);
    auto cause = separated ? std::nullopt : cause_in_cell(space, i, goal.point);
    causes.push_back(cause ? *std::move(cause) : Separated{i});
  }
  return causes;
}

Failure failure_in_cells(const FreeSpace& space, const Query& query, Status status) {
  Failure failure{.status = status,
                  .places = cells_of(space),
                  .start = end_in_cell(query.start.point()),
                  .causes = causes_in_cells(space, query, status)};
  if (!query.goals.empty()) failure.tolerance = query.goals.front().tolerance;
  for (const Goal& goal : query.goals) failure.goals.push_back(end_in_cell(goal.point));
  return failure;
}

std::optional<InvalidQuery> fault_of(const Query& query) {
  using Fault = InvalidQuery::Fault;
  if (query.goals.empty()) return InvalidQuery{Fault::no_goal};
  if (!std::ranges::all_of(query.goals, has_tolerances)) return InvalidQuery{Fault::tolerance};
  if (std::isnan(query.limits.seconds)) return InvalidQuery{Fault::seconds};
  return std::nullopt;
}

bool is_limit(Status status) {
  return status == Status::expansion_limit || status == Status::time_limit ||
         status == Status::step_limit || status == Status::cancelled;
}

}  // namespace wend
