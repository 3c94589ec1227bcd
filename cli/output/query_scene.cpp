#include "cli/output/query_scene.hpp"

#include "cli/arguments/planner_argument.hpp"
#include "cli/output/no_path_scene.hpp"

namespace wend::cli {
namespace {

bool is_about_an_end(Status status) {
  return status == Status::start_outside || status == Status::start_blocked ||
         status == Status::goal_outside || status == Status::goal_blocked ||
         status == Status::unreachable;
}

Cell start_cell(const Query& query, const Units& units) {
  return units.place("start", query.start.point()).cell;
}

}  // namespace

std::vector<Cell> cells_of_goals(const Query& query, const Units& units) {
  std::vector<Cell> cells;
  cells.reserve(query.goals.size());
  for (const Goal& goal : query.goals) cells.push_back(units.place("goal", goal.point).cell);
  return cells;
}

Scene query_scene(const PlannerSpec& planner, const FreeSpace& space, const Query& query) {
  Scene scene{.space = space};
  const PlannerInfo& info = info_of(planner);
  if (!info.capabilities.headings) {
    const Units units(space.map());
    scene.start = centre_of(start_cell(query, units));
    for (const Cell goal : cells_of_goals(query, units)) scene.goals.emplace_back(centre_of(goal));
    return scene;
  }
  scene.start = query.start;
  for (const Goal& goal : query.goals) {
    scene.goals.push_back(goal.heading ? ScenePlace(Pose{goal.point.x, goal.point.y, *goal.heading})
                                       : ScenePlace(goal.point));
  }
  scene.places = places_of(info, space, planner.options);
  return scene;
}

Scene failure_scene(const PlannerSpec& planner, const FreeSpace& space, const Query& query,
                    Status status, GridMoves moves, const Coordinates& coordinates) {
  if (info_of(planner).capabilities.headings || !is_about_an_end(status)) {
    return query_scene(planner, space, query);
  }
  return no_path_scene(space, start_cell(query, coordinates), cells_of_goals(query, coordinates),
                       moves, coordinates);
}

}  // namespace wend::cli
