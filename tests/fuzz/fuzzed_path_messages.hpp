#pragma once

// Paths in messages with any bytes at all as poses, orientations, frames and stamps. What is not a path is refused with
// the pose that is wrong; what is one becomes a route that a follower can drive, and a trajectory if its stamps increase.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "checks.hpp"
#include "fuzzed_bytes.hpp"
#include "fuzzed_follow.hpp"
#include "wend/control/follower.hpp"
#include "wend_ros/given_path.hpp"
#include "wend_ros/tracking.hpp"

namespace wend::test {

/// A path, and what its numbers say without wend.
struct FuzzedPathMessage {
  wend_ros::GivenPath path = {};
  bool sound = true;    // every pose is one, beyond doubt
  bool broken = false;  // a pose has NaN, infinity or another frame
};

inline wend_ros::Orientation fuzzed_orientation(FuzzedBytes& bytes, double heading, bool& sound) {
  const std::uint8_t kind = bytes.byte();
  wend_ros::Orientation turn{0, 0, std::sin(heading / 2), std::cos(heading / 2)};
  if (kind < 200) return turn;
  sound = false;
  if (kind < 210) return {};
  if (kind < 225) return {0.01 * bytes.byte(), 0.01 * bytes.byte(), turn.z, turn.w};
  return {bytes.number(), bytes.number(), bytes.number(), bytes.number()};
}

inline FuzzedPathMessage fuzzed_path_message(FuzzedBytes& bytes) {
  FuzzedPathMessage message;
  message.path.frame_id = bytes.byte() < 128 ? "map" : "";
  const int count = bytes.byte() % 12;
  Pose pose{5, 5, 0};
  std::uint32_t seconds = bytes.integer<std::uint32_t>();
  for (int i = 0; i < count; ++i) {
    pose = fuzzed_pose(bytes, pose);
    wend_ros::GivenStampedPose& given = message.path.poses.emplace_back();
    const std::uint8_t odd = bytes.byte();
    if (odd < 8) given.frame_id = bytes.text();
    seconds += odd < 240 ? odd % 4 : bytes.any<std::uint32_t>();
    given.stamp = {seconds, odd < 240 ? 0 : bytes.any<std::uint32_t>()};
    const double height = odd == 255 ? bytes.number() : 0;
    const double heading = std::isfinite(pose.heading) ? pose.heading : 0;
    given.pose = {pose.x, pose.y, height, fuzzed_orientation(bytes, heading, message.sound)};
    const bool finite = std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(height);
    const bool here = given.frame_id.empty() || given.frame_id == message.path.frame_id;
    constexpr double kNear = 1e7;
    if (!finite || !here) message.broken = true;
    if (!(std::abs(pose.x) < kNear && std::abs(pose.y) < kNear)) message.sound = false;
  }
  if (message.broken || count == 0) message.sound = false;
  return message;
}

/// A route is driven with commands that are finite, wherever the robot is.
inline std::string check_route(FuzzedBytes& bytes, const Route& route) {
  if (!route.valid()) return "a route that is not valid";
  if (!(route.length() >= 0) || !std::isfinite(route.length())) return "a route without a length";
  const auto& infos = controllers();
  const auto count = static_cast<std::size_t>(infos.end() - infos.begin());
  const ControllerInfo& info = *(infos.begin() + static_cast<std::ptrdiff_t>(bytes.byte() % count));
  const auto controller = info.make({}).value();
  Follower follower(*controller);
  follower.follow(route);
  Pose pose{5, 5, 0};
  for (int i = 0; i < 10; ++i) {
    pose = fuzzed_pose(bytes, pose);
    const FollowerStep step = follower.step({pose.x, pose.y, pose.heading}, 0.05);
    if (!is_finite(step.command)) return "a command that is not finite";
  }
  return {};
}

inline std::string check_trajectory(const Trajectory& trajectory) {
  if (!(trajectory.duration() >= 0) || !std::isfinite(trajectory.duration())) {
    return "a trajectory without a duration";
  }
  for (const TrajectoryState& state : trajectory.samples(trajectory.duration() / 7)) {
    const double sum = state.time + state.pose.x + state.pose.y + state.pose.heading + state.speed +
                       state.turn_rate;
    if (!std::isfinite(sum)) return "a state that is not finite";
  }
  const std::string why = wend_ros::why_untrackable(trajectory, {});
  return why.empty() ? "" : check_text(why);
}

inline std::string fuzz_path_messages(std::string_view input) {
  FuzzedBytes bytes(input);
  const FuzzedPathMessage message = fuzzed_path_message(bytes);
  const auto refused_rightly = [&](const Error& error) -> std::string {
    return message.sound ? "a path is refused: " + error.message : check_text(error.message);
  };
  for (const auto& route :
       {wend_ros::route_from(message.path), wend_ros::route_through(message.path)}) {
    if (route && message.broken) return "a path with a broken pose is taken";
    std::string wrong = route ? check_route(bytes, *route) : refused_rightly(route.error());
    if (!wrong.empty()) return wrong;
  }
  const auto trajectory = wend_ros::trajectory_from(message.path);
  if (trajectory && message.broken) return "a trajectory with a broken pose is taken";
  return trajectory ? check_trajectory(*trajectory) : check_text(trajectory.error().message);
}

}  // namespace wend::test
