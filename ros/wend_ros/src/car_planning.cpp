#include "wend_ros/car_planning.hpp"

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/thread_time.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/car_primitives.hpp"
#include "wend/robot/repeated_moves.hpp"
#include "wend/session/failure_text.hpp"

namespace wend_ros {
namespace {

constexpr double kRough = 2;
constexpr int kMostCorners = 8193;

std::string text_of(int x, int y) {
  return "(" + std::to_string(x) + "," + std::to_string(y) + ")";
}

wend::Unexpected<wend::Error> wrong(std::string what) {
  return wend::failure(wend::Status::unsupported_query, std::move(what));
}

CarResult car_refusal(StatusCode code, std::string reason) {
  CarResult result;
  result.status = static_cast<std::uint16_t>(code);
  result.status_name = to_string(code);
  result.reason = std::move(reason);
  return result;
}

std::optional<std::string> first_outside(const std::vector<YardCell>& cells, const char* name,
                                         int width, int height) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const YardCell& cell = cells[i];
    if (cell.x >= 0 && cell.y >= 0 && cell.x < width && cell.y < height) continue;
    return std::string(name) + "[" + std::to_string(i) + "]: the cell " + text_of(cell.x, cell.y) +
           " is outside: x from 0 to " + std::to_string(width - 1) + ", y from 0 to " +
           std::to_string(height - 1);
  }
  return std::nullopt;
}

wend::Expected<wend::Pose, wend::Error> pose_of(const CarPose& pose, const char* name) {
  if (pose.d < 0 || pose.d >= wend::kHeadings) {
    return wrong(std::string(name) + ": the heading must be 0 (N), 1 (W), 2 (E) or 3 (S), not " +
                 std::to_string(pose.d));
  }
  const wend::CornerPose corner{{pose.x, pose.y}, static_cast<wend::Heading>(pose.d)};
  return wend::pose_of(corner);
}

void put_plan(CarResult& result, const wend::Plan& plan) {
  for (const wend::Pose& pose : plan.path.poses()) {
    CarPose& stop = result.path.emplace_back();
    stop.x = static_cast<std::int32_t>(std::lround(pose.x));
    stop.y = static_cast<std::int32_t>(std::lround(pose.y));
    stop.d = static_cast<std::int32_t>(wend::nearest_heading(pose.heading));
  }
  const auto poses = plan.path.driven_poses();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto from = wend::nearest_corner_pose(poses[i - 1]);
    const auto to = wend::nearest_corner_pose(poses[i]);
    for (std::uint8_t move = 0; from && to && move < wend::kCarMoves; ++move) {
      if (wend::moved(*from, static_cast<wend::CarMove>(move)) == *to) result.moves.push_back(move);
    }
  }
  result.fuel = plan.cost;
}

std::string pose_text(const CarPose& pose) {
  return "(" + std::to_string(pose.x) + "," + std::to_string(pose.y) + "," +
         std::string(wend::letter_of(static_cast<wend::Heading>(pose.d), wend::Frame{})) + ")";
}

}  // namespace

wend::Expected<wend::GridMap, wend::Error> yard_of(const CarRequest& request) {
  const auto in_range = [](int corners) { return corners >= 2 && corners <= kMostCorners; };
  if (!in_range(request.mapWidth) || !in_range(request.mapHeight)) {
    return wrong("mapWidth and mapHeight count corners, from 2 to " + std::to_string(kMostCorners) +
                 ", not " + std::to_string(request.mapWidth) + " x " +
                 std::to_string(request.mapHeight));
  }
  const int width = request.mapWidth - 1;
  const int height = request.mapHeight - 1;
  if (auto outside = first_outside(request.obstacles, "obstacles", width, height)) {
    return wrong(*std::move(outside));
  }
  if (auto outside = first_outside(request.roughRoads, "roughRoads", width, height)) {
    return wrong(*std::move(outside));
  }
  wend::Grid<wend::CellState> cells(width, height, wend::CellState::free);
  wend::Grid<double> terrain;
  if (!request.roughRoads.empty()) terrain = {width, height, 1.0};
  for (const YardCell& cell : request.obstacles) {
    cells[{cell.x, cell.y}] = wend::CellState::occupied;
  }
  for (const YardCell& cell : request.roughRoads) terrain[{cell.x, cell.y}] = kRough;
  return *wend::make_grid_map(cells, {}, std::move(terrain));
}

CarResult plan_car(const CarRequest& request, const Watch& watch) {
  auto yard = yard_of(request);
  if (!yard) return car_refusal(StatusCode::invalid_request, yard.error().message);
  const auto start = pose_of(request.start, "start");
  if (!start) return car_refusal(StatusCode::invalid_request, start.error().message);
  const auto goal = pose_of(request.goal, "goal");
  if (!goal) return car_refusal(StatusCode::invalid_request, goal.error().message);

  auto planner = wend::make_planner("car", *wend::make_free_space(*std::move(yard)), {});
  if (!planner) return car_refusal(code_of(planner.error().status), planner.error().message);
  wend::Query query{.start = *start, .goals = {*goal}};
  query.limits.cancel = watch.cancel;
  query.observer = watch.observer;
  wend::Plan plan;
  double seconds = 0;
  const wend::Status status =
      wend::timed(wend::thread_cpu_seconds, seconds, [&] { return (*planner)->plan(query, plan); });
  CarResult result = car_refusal(code_of(status), {});
  if (status == wend::Status::found) {
    put_plan(result, plan);
  } else {
    result.reason =
        wend::words_of((*planner)->failure(query, status), plan.metrics, (*planner)->free_space());
  }
  result.metrics.expanded = plan.metrics.expanded;
  result.metrics.generated = plan.metrics.generated;
  result.metrics.max_frontier = plan.metrics.max_frontier;
  result.metrics.seconds = seconds;
  return result;
}

CarRequest request_for(const wend::GridMap& yard) {
  CarRequest request;
  request.mapWidth = yard.width() + 1;
  request.mapHeight = yard.height() + 1;
  for (int y = 0; y < yard.height(); ++y) {
    for (int x = 0; x < yard.width(); ++x) {
      YardCell cell;
      cell.x = x;
      cell.y = y;
      if (yard.state({x, y}) != wend::CellState::free) {
        request.obstacles.push_back(cell);
      } else if (yard.terrain({x, y}) > 1) {
        request.roughRoads.push_back(cell);
      }
    }
  }
  return request;
}

std::vector<std::string> commands_of(const CarResult& result) {
  if (result.path.empty()) return {};
  std::vector<std::string> lines{"Start " + pose_text(result.path.front())};
  std::vector<std::string_view> names;
  for (const auto move : result.moves) {
    names.push_back(wend::name_of(static_cast<wend::CarMove>(move), wend::Frame{}));
  }
  for (const wend::RepeatedMove& move : wend::merged_moves(names)) {
    lines.push_back("Go " + wend::text_of(move) + " -> " + pose_text(result.path[move.end]));
  }
  return lines;
}

wend::Path path_of(const CarResult& result) {
  wend::Path path;
  for (const CarPose& pose : result.path) {
    path.drive_to(
        wend::pose_of(wend::CornerPose{{pose.x, pose.y}, static_cast<wend::Heading>(pose.d)}));
  }
  return path;
}

}  // namespace wend_ros
