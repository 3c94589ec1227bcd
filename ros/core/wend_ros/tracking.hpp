#pragma once

// What the follower asks of a trajectory before it tracks it.

#include <string>

#include "wend/control/motion_model.hpp"
#include "wend/path/trajectory.hpp"

namespace wend_ros {

/// Why a differential-drive robot cannot track a trajectory: it steps to the side, or is faster than the
/// robot. Empty if it can.
std::string why_untrackable(const wend::Trajectory& trajectory, const wend::VelocityLimits& limits);

}  // namespace wend_ros
