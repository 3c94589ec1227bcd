#pragma once

// SilenceWatch: has somebody fallen silent without whom a robot must not drive on? Knows no ROS, nor a clock.
//
//   wend_ros::SilenceWatch watch({.planner_timeout = 0.3});
//   watch.hear_planner(now);
//   if (watch.silent(later) == wend_ros::Silent::planner) brake();

#include <limits>

namespace wend_ros {

/// For how long they may be silent, s; 0: for ever.
struct SilenceLimits {
  double planner_timeout = 0.3;
  double map_timeout = 0;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"planner_timeout",
           "time without a sign of life of the planner after which the robot brakes, s; 0 = never"},
          self.planner_timeout, {0, 3600});
    field({"map_timeout",
           "time without a message of the map after which the robot brakes, s; 0 = never: for maps "
           "that do not change regularly"},
          self.map_timeout, {0, 3600});
  }
};

enum class Silent { nobody, planner, map };

class SilenceWatch {
 public:
  explicit SilenceWatch(const SilenceLimits& limits) : limits_(limits) {}

  /// At a time in seconds, of any clock that never goes back.
  void hear_planner(double now) { planner_ = now; }
  void hear_map(double now) { map_ = now; }

  /// Who has been silent for too long. Nobody has been heard at first.
  Silent silent(double now) const {
    if (limits_.planner_timeout > 0 && now - planner_ > limits_.planner_timeout) {
      return Silent::planner;
    }
    if (limits_.map_timeout > 0 && now - map_ > limits_.map_timeout) return Silent::map;
    return Silent::nobody;
  }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  SilenceLimits limits_;
  double planner_ = kNever;
  double map_ = kNever;
};

}  // namespace wend_ros
