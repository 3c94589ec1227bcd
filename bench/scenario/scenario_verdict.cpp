#include "bench/scenario/scenario_verdict.hpp"

#include <fmt/format.h>

#include "wend/base/parse.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {

std::string wrong_answer(const FreeSpace& space, GridMoves moves, const ScenarioQuery& query,
                         Status status, const Plan& plan, PathKind kind) {
  if (status == Status::time_limit) return {};
  if (status != Status::found) {
    if (query.says_no_path()) return {};
    return fmt::format("found none ({}), expected one of length {}", describe(status),
                       format_number(query.length));
  }
  const auto cells = plan.path.cells();
  const auto waypoints = plan.path.waypoints();
  const bool joins = waypoints.empty() ? !cells.empty() && cells.front() == query.start &&
                                             cells.back() == query.goal
                                       : waypoints.front() == centre_of(query.start) &&
                                             waypoints.back() == centre_of(query.goal);
  if (!joins) return "the path does not join start and goal";
  const auto length = kind != PathKind::lines ? check_grid_path(space, moves, cells)
                      : waypoints.empty()
                          ? check_any_angle_path(space, moves.adjacency(), cells)
                          : check_any_angle_path(space, moves.adjacency(), waypoints);
  if (!length) return "not a valid path: " + length.error().what;
  if (query.says_no_path()) {
    return fmt::format("found a path of length {:.8g}, expected none", *length);
  }
  if (length_matches(query, *length)) return {};
  const bool shorter = *length < query.length;
  if (shorter && kind == PathKind::lines) return {};
  const double least = *length / plan.bound;  // if the bound is true
  if (!shorter && (least <= query.length || length_matches(query, least))) return {};
  const std::string expected = format_number(query.length);
  return fmt::format("found a path of length {:.8f}, expected {}", *length,
                     shorter || plan.bound == 1
                         ? expected
                         : fmt::format("at most {:.8g} times {}", plan.bound, expected));
}

}  // namespace wend
