// SPDX-License-Identifier: Apache-2.0
#pragma once

// SafeVelocity: the velocity nearest to a wanted one from which the robot can still stop without a collision. Knows no
// ROS.
//
// The robot holds the velocity for a period and then brakes; what its footprint sweeps on the way has to be free. If
// that of the wanted velocity is not, slower ones on the same curve are tried, and in the end braking at once. On a
// costmap that does not change, a robot that obeys therefore never collides. A robot that overlaps something already
// may drive where it does not go deeper: wend::DepthWatch says what that is.

#include <optional>

#include "wend/control/motion_model.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend_nav2 {

/// What the robot drives if it holds its velocity for `seconds` and then brakes to a stop, in grid coordinates.
wend::Path stopping_path(const wend::MotionModel& model, const wend::RobotState& state,
                         double seconds, const wend::Frame& frame);

/// The velocity to hold for `seconds`, within the robot's limits of acceleration: `wanted`, or a slower one.
/// Nothing if not even braking is free, or, for a robot that overlaps something, goes no deeper. `state` has the velocity that the robot was last told.
std::optional<wend::Velocity> safe_velocity(const wend::MotionModel& model,
                                            const wend::RobotState& state,
                                            const wend::Velocity& wanted, double seconds,
                                            const wend::FreeSpace& space);

}  // namespace wend_nav2
