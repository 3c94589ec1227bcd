#include "wend/report/trajectory_report.hpp"

#include <fmt/format.h>

#include "wend/report/json.hpp"

namespace wend {

Json json_of(const SampledTrajectory& sampled) {
  const Trajectory& trajectory = sampled.trajectory;
  Json limits;
  TrajectoryLimits::fields(trajectory.limits(),
                           [&](const OptionText& text, double value, OptionRange) {
                             limits[std::string(text.name)] = value;
                           });
  Json samples{{"time_s", Json::array()},     {"x_m", Json::array()},
               {"y_m", Json::array()},        {"yaw", Json::array()},
               {"linear_m_s", Json::array()}, {"angular_rad_s", Json::array()}};
  for (const TrajectoryState& state : trajectory.samples(sampled.period)) {
    samples["time_s"].push_back(state.time);
    samples["x_m"].push_back(state.pose.x);
    samples["y_m"].push_back(state.pose.y);
    samples["yaw"].push_back(state.pose.heading);
    samples["linear_m_s"].push_back(state.speed);
    samples["angular_rad_s"].push_back(state.turn_rate);
  }
  return {{"duration_s", trajectory.duration()},
          {"length_m", trajectory.length()},
          {"limits", limits},
          {"samples", samples}};
}

std::string trajectory_json(const SampledTrajectory& sampled) {
  return text_of(Json{{"trajectory", json_of(sampled)}});
}

std::string trajectory_text(const Trajectory& trajectory) {
  return fmt::format("{:<10}{:.2f} s for {:.2f} m\n", "duration", trajectory.duration(),
                     trajectory.length());
}

}  // namespace wend
