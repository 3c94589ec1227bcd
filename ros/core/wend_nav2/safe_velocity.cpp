// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/safe_velocity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "wend/path/lead_out.hpp"
#include "wend/path/path_collision.hpp"

namespace wend_nav2 {
namespace {

// What of the wanted velocity is tried, the last one to brake.
constexpr std::array kShares{1.0, 0.7, 0.5, 0.3, 0.15, 0.0};

// More steps of braking would take longer than they are worth.
constexpr double kMostSteps = 200;

/// Is a way safe for a robot that overlaps something where it begins? It must not go deeper.
bool leads_out(const wend::Path& path, const wend::FreeSpace& space) {
  wend::DepthWatch watch(space, path.driven_poses().front());
  const wend::JoinedPoses poses(path.driven_poses());
  for (std::size_t i = 0; i < poses.segment_count(); ++i) {
    if (!watch.go_along(poses.segment(i))) return false;
  }
  return true;
}

bool is_standing(const wend::Velocity& velocity) { return velocity == wend::Velocity{}; }

}  // namespace

wend::Path stopping_path(const wend::MotionModel& model, const wend::RobotState& state,
                         double seconds, const wend::Frame& frame) {
  const wend::VelocityLimits& limits = model.limits;
  const double to_stop = std::max(std::abs(state.velocity.linear) / limits.acceleration,
                                  std::abs(state.velocity.angular) / limits.turn_acceleration);
  const double step = std::max(seconds, to_stop / kMostSteps);
  std::vector<wend::Pose> poses{frame.to_grid(state.pose)};
  wend::RobotState now = wend::hold(state.pose, state.velocity, step).to;
  poses.push_back(frame.to_grid(now.pose));
  while (!is_standing(now.velocity)) {
    now = wend::drive(model, now, {}, step).to;
    poses.push_back(frame.to_grid(now.pose));
  }
  return wend::Path::through(std::move(poses));
}

std::optional<wend::Velocity> safe_velocity(const wend::MotionModel& model,
                                            const wend::RobotState& state,
                                            const wend::Velocity& wanted, double seconds,
                                            const wend::FreeSpace& space) {
  const bool overlaps = !space.fits(space.map().frame().to_grid(state.pose));
  for (const double share : kShares) {
    const wend::Velocity slower{share * wanted.linear, share * wanted.angular};
    const wend::Velocity velocity = wend::drive(model, state, slower, seconds).to.velocity;
    const wend::Path path =
        stopping_path(model, {state.pose, velocity}, seconds, space.map().frame());
    if (overlaps ? leads_out(path, space) : !wend::first_collision(path, space)) return velocity;
  }
  return std::nullopt;
}

}  // namespace wend_nav2
