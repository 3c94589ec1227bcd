#include "cli/arguments/typed_request.hpp"

#include <fmt/format.h>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/exit_code.hpp"

namespace wend::cli {
namespace {

void read_cells(PlanRequest& request, const Coordinates& coordinates, const EndArguments& ends) {
  request.texts.start = coordinates.parse("start", ends.start).text;
  const Point start = coordinates.parse_in_grid("start", ends.start);
  request.start = {start.x, start.y, 0};
  for (const std::string& goal : ends.goals) {
    request.texts.goals.push_back(coordinates.parse("goal", goal).text);
    const Point point = coordinates.parse_in_grid("goal", goal);
    request.goals.push_back({.point = {point.x, point.y}, .heading = 0});
  }
}

void read_poses(PlanRequest& request, const Coordinates& coordinates, const PlaceGrid& places,
                const EndArguments& ends) {
  const TypedPose start = parse_start_pose(coordinates, ends.start, places);
  request.texts.start = start.text;
  request.start = {start.point.x, start.point.y, start.heading.value_or(0)};
  for (const std::string& goal : ends.goals) {
    const TypedPose pose = parse_goal_pose(coordinates, goal, places);
    request.texts.goals.push_back(pose.text);
    request.goals.push_back({.point = {pose.point.x, pose.point.y}, .heading = pose.heading});
  }
}

}  // namespace

void add_goal_tolerance(Parser& app, std::string& tolerance) {
  app.add_option("--goal-tolerance", tolerance,
                 wrapped("How far from a goal the path may end: a distance in the units of --goal, "
                         "and for planners with headings an angle in degrees. The goal itself may "
                         "then be blocked"))
      .type_name("DISTANCE[,DEGREES]");
}

PlanRequest typed_request(const PlannerSpec& planner, const FreeSpace& space,
                          const Coordinates& coordinates, const EndArguments& ends) {
  PlanRequest request;
  request.planner = planner;
  request.coordinates = MapUnits::cells;
  request.wording = coordinates.metric() ? MapUnits::metres : MapUnits::cells;
  const PlannerInfo& info = info_of(planner);
  const bool poses = info.capabilities.headings;
  if (poses) {
    read_poses(request, coordinates, places_of(info, space, planner.options), ends);
  } else {
    read_cells(request, coordinates, ends);
  }
  const GoalTolerance tolerance = parse_goal_tolerance(coordinates, ends.tolerance);
  for (MapGoal& goal : request.goals) {
    goal.tolerance = tolerance.distance;
    goal.heading_tolerance = tolerance.heading;
  }
  if (poses || tolerance.heading == 0) return request;
  throw InputError(
      fmt::format("--goal-tolerance {}: grid planners have no headings: leave out the degrees",
                  ends.tolerance));
}

}  // namespace wend::cli
