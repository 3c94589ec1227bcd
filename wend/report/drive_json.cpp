#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/report/drive_report.hpp"
#include "wend/report/path_json.hpp"

namespace wend {
namespace {

Json json_of(const std::vector<DriveSample>& samples, const Frame& frame) {
  Json columns;
  for (const char* name : {"time_s", "x_m", "y_m", "yaw", "linear_m_s", "angular_rad_s",
                           "heading_error_degrees", "cross_track_m"}) {
    columns[name] = Json::array();
  }
  for (const DriveSample& sample : samples) {
    const Pose pose = frame.to_metres(sample.pose);
    columns["time_s"].push_back(sample.time);
    columns["x_m"].push_back(pose.x);
    columns["y_m"].push_back(pose.y);
    columns["yaw"].push_back(pose.heading);
    columns["linear_m_s"].push_back(sample.velocity.linear);
    columns["angular_rad_s"].push_back(sample.velocity.angular);
    columns["heading_error_degrees"].push_back(degrees_from(sample.heading_error));
    columns["cross_track_m"].push_back(sample.cross_track);
  }
  return columns;
}

Json json_of(const ControlledDrive& driven, const Frame& frame, DriveSamples samples) {
  const Drive& drive = driven.drive;
  Json json{{"controller", driven.controller},
            {"outcome", choice_name(drive.outcome)},
            {"time_s", drive.time},
            {"distance_m", drive.distance},
            {"turned_degrees", degrees_from(drive.turned)},
            {"cross_track_rms_m", drive.cross_track_rms},
            {"cross_track_largest_m", drive.cross_track_largest},
            {"final_error_m", drive.final_error},
            {"final_heading_error_degrees", degrees_from(drive.final_heading_error)},
            {"swings", drive.swings},
            {"collisions", drive.collisions},
            {"first_collision", Json()},
            {"first_collision_m", Json()}};
  if (drive.first_collision) {
    const Point metres = frame.to_metres(*drive.first_collision);
    json["first_collision"] = json_of(*drive.first_collision);
    json["first_collision_m"] = Json::array({metres.x, metres.y});
  }
  if (samples == DriveSamples::all) json["samples"] = json_of(drive.samples, frame);
  return json;
}

}  // namespace

std::string drive_json(const RefinedPath& path, std::span<const ControlledDrive> drives,
                       const Frame& frame, DriveSamples samples) {
  Json json;
  put_paths(json, path, frame);
  json["drives"] = Json::array();
  for (const ControlledDrive& driven : drives) {
    json["drives"].push_back(json_of(driven, frame, samples));
  }
  return text_of(json);
}

}  // namespace wend
