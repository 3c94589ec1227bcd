// SPDX-License-Identifier: Apache-2.0
#pragma once

// PathSmoother: smooths the poses of any planner's path on the costs of a costmap, and keeps it free. Knows no ROS.
//
// A path is cut where it changes its direction by more than a right angle, or turns in place: gear changes stay where
// they are, and so do both ends. Poses face along the way as they did before, ahead or in reverse
// (wend/control/given_route.hpp).

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/session/session.hpp"
#include "wend_nav2/costmap_copy.hpp"
#include "wend_nav2/failure.hpp"
#include "wend_nav2/planner_settings.hpp"
#include "wend_nav2/robot_shape.hpp"

namespace wend_nav2 {

/// What concerns all smoothers.
struct SmootherOptions {
  ObstacleRule obstacles = ObstacleRule::automatic;
  bool allow_unknown = true;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"obstacles",
           "what keeps the robot from obstacles: inscribed (its centre stays out of costs from "
           "253), footprint (its footprint out of cost 254), or auto: footprint, and inscribed for "
           "the path of a round robot that is free by that rule alone"},
          self.obstacles);
    field({"allow_unknown", "whether the robot may drive into unknown cells"}, self.allow_unknown);
  }

  friend bool operator==(const SmootherOptions&, const SmootherOptions&) = default;
};

/// The name of the parameter that chooses the smoother.
inline constexpr std::string_view kSmootherParameter = "smoother";

/// The parameters of the plugin for one smoother.
struct SmootherSchema {
  wend::OptionInfo name;                 // which smoother: gradient or curvature
  std::vector<wend::OptionInfo> plugin;  // SmootherOptions
  std::vector<wend::OptionInfo>
      smoother;  // the smoother's own, without `unsafe`; empty if it is unknown
};

SmootherSchema smoother_schema(std::string_view smoother);

struct SmootherSettings {
  std::string smoother = "gradient";
  SmootherOptions plugin = {};
  wend::OptionValues options = {};
};

/// Settings of all parameters as text. Fails with invalid_option for an unknown smoother or name and a value out of
/// range.
wend::Expected<SmootherSettings, wend::Error> smoother_settings_from(
    std::string_view smoother, const wend::OptionValues& values);

/// One thread at a time.
class PathSmoother {
 public:
  using Poses = std::vector<wend::MapPose>;

  struct Result {
    Poses poses = {};
    bool complete = true;  // else the time was up, and the rest of the path is as it was
  };

  void set(SmootherSettings settings) { settings_ = std::move(settings); }

  CostmapCopy& costmap() { return costmap_; }

  /// Smooths a path in the costmap's frame; `time_is_up` is asked before each piece. A path of fewer than three poses
  /// is as it was. Fails with no_valid_path, and the place, if the path has a pose that fault_of() finds, leaves the
  /// costmap or is not free.
  wend::Expected<Result, Failure> smooth(const Poses& path, const RobotShape& robot,
                                         const std::function<bool()>& time_is_up);

 private:
  wend::Expected<Result, Failure> smooth_by(ObstacleRule rule, const Poses& path,
                                            const RobotShape& robot,
                                            const std::function<bool()>& time_is_up);

  wend::Session session_;
  CostmapCopy costmap_;
  SmootherSettings settings_;
};

}  // namespace wend_nav2
