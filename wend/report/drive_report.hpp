#pragma once

// How robots drove along a path: a comparison of controllers, for people and for programs. See
// simulation.hpp for the meaning of each number.

#include <cstddef>
#include <span>
#include <string>

#include "wend/control/simulation.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/report/path_report.hpp"

namespace wend {

struct ControlledDrive {
  std::string controller;  // as typed: "pid:heading_gain=3"
  Drive drive;
};

/// For one drive, a line for each value. For several, a line for each controller; in each column the best
/// of those that reached the goal is marked. Columns for which there is no room in that width follow below.
std::string drive_table(std::span<const ControlledDrive> drives, std::size_t width = 80);

enum class DriveSamples { none, all };

/// {"schema": 1, "drives": [{"controller", "outcome", "time_s", "distance_m", "turned_degrees",
/// "cross_track_rms_m", "cross_track_largest_m", "final_error_m", "final_heading_error_degrees",
/// "swings", "collisions", "first_collision", "first_collision_m", "samples": {"time_s", "x_m", "y_m", "yaw",
/// "linear_m_s", "angular_rad_s", "heading_error_degrees", "cross_track_m"}}]}. Collisions are
/// points in grid coordinates and in metres, null if unset. Each of the samples is a list; their poses
/// are in the map's frame. The keys of smoothing_json() for the path come first. One line with its line
/// end.
std::string drive_json(const RefinedPath& path, std::span<const ControlledDrive> drives,
                       const Frame& frame, DriveSamples samples);

/// The samples of all drives, a line each, after the names of the columns: "controller,time_s,x_m,
/// y_m,yaw,linear_m_s,angular_rad_s,heading_error_rad,cross_track_m".
std::string drive_csv(std::span<const ControlledDrive> drives, const Frame& frame);

}  // namespace wend
