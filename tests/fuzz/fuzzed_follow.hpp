#pragma once

// Drives along any path, with every controller, any robot and any options: what they answer is finite, and "reached"
// is true.

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzzed_bytes.hpp"
#include "wend/control/given_route.hpp"
#include "wend/control/simulation.hpp"

namespace wend::test {

/// A room with a pillar.
inline const FreeSpace& fuzzed_room() {
  static const FreeSpace room = [] {
    Grid<CellState> cells(40, 30, CellState::free);
    for (int y = 12; y < 15; ++y) cells[{20, y}] = CellState::occupied;
    return *make_free_space(*make_grid_map(cells, {.resolution = 0.5}),
                            {.footprint = Footprint::disc(0.2)});
  }();
  return room;
}

/// Often near the pose before, also by next to nothing.
inline Pose fuzzed_pose(FuzzedBytes& bytes, const Pose& before) {
  const auto moved = [&](double from) {
    const std::uint8_t kind = bytes.byte();
    if (kind < 60) return from;
    if (kind < 100) return from + 1e-16 * bytes.byte();
    if (kind < 180) return from + 0.02 * (bytes.byte() - 128);
    return bytes.number();
  };
  const double x = moved(before.x);
  const double y = moved(before.y);
  return {x, y, moved(before.heading)};
}

inline Path fuzzed_path(FuzzedBytes& bytes) {
  const std::uint8_t kind = bytes.byte();
  std::vector<Pose> poses;
  Pose pose{5, 5, 0};
  const int count = bytes.byte() % 12;
  for (int i = 0; i < count; ++i) poses.push_back(pose = fuzzed_pose(bytes, pose));
  if (kind % 3 != 0) return Path::through(std::move(poses));
  std::vector<Point> points;
  for (const Pose& each : poses) points.push_back(each.point());
  return Path::along(std::move(points));
}

inline bool is_finite(const Velocity& velocity) {
  return std::isfinite(velocity.linear) && std::isfinite(velocity.angular) &&
         std::isfinite(velocity.lateral);
}

/// What is wrong with a drive; empty if nothing is.
inline std::string check_drive(const Drive& drive, const Path& path, const FollowerOptions& asked) {
  if (drive.outcome == DriveOutcome::refused) {
    return drive.refusal.empty() || !drive.samples.empty() ? "a refusal that is none" : "";
  }
  if (drive.samples.empty()) return "a drive without samples";
  for (const DriveSample& sample : drive.samples) {
    const double sum = sample.time + sample.pose.x + sample.pose.y + sample.pose.heading +
                       sample.heading_error + sample.cross_track;
    if (!std::isfinite(sum) || !is_finite(sample.velocity)) return "a sample that is not finite";
  }
  if (drive.outcome != DriveOutcome::reached) return {};
  const DriveSample& last = drive.samples.back();
  const Pose goal = path.poses().back();
  const double gap = std::hypot(last.pose.x - goal.x, last.pose.y - goal.y) *
                     fuzzed_room().map().frame().resolution;
  const double turned = std::remainder(last.pose.heading - goal.heading, 2 * kPi);
  constexpr double kRounding = 1e-6;
  if (last.velocity != Velocity{}) return "it has reached the goal and still moves";
  if (gap > asked.goal_tolerance + kRounding) return "it has reached the goal elsewhere";
  const bool heads = path.driven() && asked.heading_tolerance > 0;
  if (heads && std::abs(turned) > asked.heading_tolerance + kRounding) {
    return "it has reached the goal turned away";
  }
  return {};
}

/// A follower by itself answers finite commands, wherever the robot is.
inline std::string check_commands(FuzzedBytes& bytes, Controller& controller, const Path& path) {
  Follower follower(controller);
  follower.follow(Route(path, Frame{}));
  Pose pose{5, 5, 0};
  for (int i = 0; i < 20; ++i) {
    pose = fuzzed_pose(bytes, pose);
    const FollowerStep step = follower.step({pose.x, pose.y, pose.heading}, 0.05);
    if (!is_finite(step.command)) return "a command that is not finite";
  }
  return {};
}

inline std::string fuzz_follow(std::string_view data) {
  FuzzedBytes bytes(data);
  const auto& infos = controllers();
  const auto count = static_cast<std::size_t>(infos.end() - infos.begin());
  const ControllerInfo& info = *(infos.begin() + static_cast<std::ptrdiff_t>(bytes.byte() % count));
  const auto controller = info.make({}).value();
  const std::uint8_t odd = bytes.byte();
  MotionModel model{.drivetrain = static_cast<Drivetrain>(bytes.byte() % 3)};
  SimulationOptions options{.time_limit = 30};
  FollowerOptions asked;
  if (odd % 4 == 1) model.limits.speed = bytes.number();
  if (odd % 4 == 2) options.latency = bytes.number();
  if (odd % 8 == 3) options.position_noise = 0.01;
  if (odd % 8 == 7) asked.goal_tolerance = bytes.number();
  if (odd % 16 == 8) options.rate = bytes.number() > 20 ? 20 : 5;
  const Path path = fuzzed_path(bytes);
  const std::string wrong =
      check_drive(simulate(fuzzed_room(), path, *controller, model, options, asked), path, asked);
  if (!wrong.empty() || path.empty()) return wrong;
  std::vector<MapPose> poses;
  for (const Pose& pose : path.poses()) poses.push_back({pose.x, pose.y, pose.heading});
  const auto route = given_route(poses);
  if (route && !route->valid()) return "a route that is not valid";
  return check_commands(bytes, *controller, path);
}

}  // namespace wend::test
