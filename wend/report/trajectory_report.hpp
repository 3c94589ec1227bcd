#pragma once

// Trajectories for programs. In JSON:
//
//   {"schema": 1, "trajectory": {"duration_s": 12.5, "length_m": 5.2, "limits": {"speed": 0.5,
//    "turn_rate": 1.5, "acceleration": 1, "turn_acceleration": 5, "lateral_acceleration": 1},
//    "samples": {"time_s": [0, 0.05, ...], "x_m": [...], "y_m": [...], "yaw": [...],
//    "linear_m_s": [...], "angular_rad_s": [...]}}}
//
// The samples are what trajectory_csv() writes, with the keys of drive_json().

#include <string>

#include "wend/path/trajectory.hpp"

namespace wend {

/// A trajectory, and how often reports sample it.
struct SampledTrajectory {
  Trajectory trajectory;
  double period = 0.05;  // s, > 0
};

/// One line with its line end.
std::string trajectory_json(const SampledTrajectory& sampled);

/// "duration  12.50 s for 5.20 m": for people, a line with its line end.
std::string trajectory_text(const Trajectory& trajectory);

}  // namespace wend
