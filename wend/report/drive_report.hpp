#pragma once

// How robots drove along a path: controllers beside each other, for people and for programs. See
// simulation.hpp for what each number is.

#include <span>
#include <string>

#include "wend/control/simulation.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/report/path_report.hpp"

namespace wend {

struct ControlledDrive {
  std::string controller;  // as it was typed: "pid:heading_gain=3"
  Drive drive;
};

/// Of one drive a line for each thing; of several a line for each controller, the best of each column
/// marked among those that reached the goal. At most 80 columns where names have no more than 16 and
/// drives take less than 1000 s.
std::string drive_table(std::span<const ControlledDrive> drives);

enum class DriveSamples { none, all };

/// {"schema": 1, "drives": [{"controller", "outcome", "time_s", "distance_m", "turned_degrees",
/// "cross_track_rms_m", "cross_track_largest_m", "final_error_m", "final_heading_error_degrees",
/// "swings", "collisions", "first_collision", "first_collision_m", "samples": {"time_s", "x_m", "y_m", "yaw",
/// "linear_m_s", "angular_rad_s", "heading_error_degrees", "cross_track_m"}}]}. Collisions are
/// points in grid coordinates and in metres, null if unset; of the samples, each a list,
/// the poses are in the map's frame. What smoothing_json() says of the path comes first. One line
/// with its line end.
std::string drive_json(const RefinedPath& path, std::span<const ControlledDrive> drives,
                       const Frame& frame, DriveSamples samples);

/// The samples of all drives, a line each, the names of the columns first: "controller,time_s,x_m,
/// y_m,yaw,linear_m_s,angular_rad_s,heading_error_rad,cross_track_m".
std::string drive_csv(std::span<const ControlledDrive> drives, const Frame& frame);

}  // namespace wend
