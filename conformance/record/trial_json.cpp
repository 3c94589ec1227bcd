#include "conformance/record/trial_json.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "conformance/answer.hpp"
#include "conformance/examination.hpp"
#include "conformance/trial.hpp"
#include "wend/base/random.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/explainer.hpp"
#include "wend/session/plan_request.hpp"
#include "wend/session/units.hpp"

namespace wend::test {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kQueries = 4;

/// The trial of the suite, on a map that has a resolution wherever its cells are not of 1 m: other interfaces have
/// no other maps. What is outside of the map does not change by that.
Trial portable_trial(const PlannerInfo& info, std::uint64_t seed) {
  Trial trial = Examination(info, std::nullopt).random_trial(seed);
  Frame frame = trial.map.frame();
  trial.robot.outside = trial.robot.outside.value_or(default_outside_policy(frame));
  frame.metric = frame.metric || frame.resolution != 1;
  trial.map = in_frame(trial.map, frame);
  return trial;
}

Json map_json(const GridMap& map) {
  const Frame& frame = map.frame();
  Json states = Json::array();
  Json terrain = Json::array();
  for (int y = 0; y < map.height(); ++y) {
    Json row = Json::array();
    Json costs = Json::array();
    for (int x = 0; x < map.width(); ++x) {
      const CellState state = map.state({x, y});
      row.push_back(state == CellState::free ? 0 : state == CellState::occupied ? 1 : -1);
      costs.push_back(map.terrain({x, y}));
    }
    states.push_back(std::move(row));
    terrain.push_back(std::move(costs));
  }
  return {{"array", std::move(states)},
          {"resolution", frame.metric ? Json(frame.resolution) : Json(nullptr)},
          {"origin", {frame.origin.x, frame.origin.y, frame.origin.heading}},
          {"costs", map.uniform_terrain() ? Json(nullptr) : std::move(terrain)},
          {"y_up", frame.y_up}};
}

Json robot_json(const FreeSpaceOptions& robot) {
  Json footprint = robot.footprint.circumscribed_radius();
  if (const Polygon* const outline = robot.footprint.outline()) {
    footprint = Json::array();
    for (const Point corner : outline->corners()) footprint.push_back({corner.x, corner.y});
  }
  const auto policy = [](bool blocked) { return blocked ? "blocked" : "free"; };
  return {{"footprint", std::move(footprint)},
          {"unknown", policy(robot.unknown == UnknownPolicy::blocked)},
          {"outside", policy(robot.outside == OutsidePolicy::blocked)},
          {"clearance_distance", robot.clearance_distance},
          {"clearance_cost", robot.clearance_cost}};
}

/// A query in metres; all of its goals have the tolerance of the first.
PlanRequest request_of(const Query& query, const Frame& frame) {
  PlanRequest request{frame.to_metres(query.start), {}};
  for (const Goal& goal : query.goals) {
    const MapPose pose =
        frame.to_metres(Pose{goal.point.x, goal.point.y, goal.heading.value_or(0)});
    MapGoal& added = request.goals.emplace_back();
    added.point = pose.point();
    if (goal.heading) added.heading = pose.heading;
    added.tolerance = query.goals.front().tolerance * frame.resolution;
    added.heading_tolerance = query.goals.front().heading_tolerance;
  }
  return request;
}

Json request_json(const PlanRequest& request) {
  Json goals = Json::array();
  for (const MapGoal& goal : request.goals) {
    Json numbers{goal.point.x, goal.point.y};
    if (goal.heading) numbers.push_back(*goal.heading);
    goals.push_back(std::move(numbers));
  }
  return {{"start", {request.start.x, request.start.y, request.start.heading}},
          {"goal", std::move(goals)},
          {"tolerance", request.goals.front().tolerance},
          {"heading_tolerance", request.goals.front().heading_tolerance}};
}

Json path_json(const Path& path, const Frame& frame) {
  Json points = Json::array();
  if (path.driven()) {
    for (const Pose& pose : path.poses()) {
      const MapPose at = frame.to_metres(pose);
      points.push_back({at.x, at.y, at.heading});
    }
  } else {
    for (const MapPoint at : path.points_in_metres(frame)) points.push_back({at.x, at.y});
  }
  return points;
}

/// The planner's answer, finished as every front end does.
Answer finished_answer(Planner& planner, Query query) {
  const FreeSpace& space = planner.free_space();
  const Units units(space.map());
  const Explainer explainer(space, units, planner.grid_moves().value_or(GridMoves{}), {});
  EasedQuery eased(std::move(query), planner, explainer, units, {});
  Answer answer = answer_of(planner, eased.query());
  if (answer.status == Status::found) eased.finish(answer.plan);
  return answer;
}

Json answer_json(const Answer& answer, const Frame& frame) {
  const SearchMetrics& work = answer.plan.metrics;
  return {{"status", to_string(answer.status)},
          {"cost", answer.plan.cost},
          {"bound", answer.plan.bound},
          {"path", path_json(answer.plan.path, frame)},
          {"metrics", {work.expanded, work.generated, work.max_frontier}}};
}

}  // namespace

std::string trial_json(const PlannerInfo& info, std::uint64_t seed) {
  const Trial trial = portable_trial(info, seed);
  const Frame& frame = trial.map.frame();
  Json options = Json::object();
  for (const auto& [name, value] : trial.options) options[name] = value;
  Json json{{"planner", info.name},          {"seed", seed},
            {"map", map_json(trial.map)},    {"robot", robot_json(trial.robot)},
            {"options", std::move(options)}, {"refused", nullptr},
            {"queries", Json::array()}};
  const auto planner = info.make(*make_free_space(trial.map, trial.robot), trial.options);
  if (!planner) json["refused"] = to_string(planner.error().status);
  Random random(seed);
  for (int i = 0; planner && i < kQueries; ++i) {
    const PlanRequest request = request_of(random_query(random, trial.map, info), frame);
    Json query = request_json(request);
    query["answer"] = answer_json(finished_answer(**planner, query_of(request, frame)), frame);
    json["queries"].push_back(std::move(query));
  }
  return json.dump();
}

}  // namespace wend::test
