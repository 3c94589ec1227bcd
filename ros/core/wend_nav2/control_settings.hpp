// SPDX-License-Identifier: Apache-2.0
#pragma once

// ControlSettings: what users set of wend_nav2/Controller, from the schemas of wend's controllers. Knows no ROS.

#include <string>
#include <string_view>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/control/follower.hpp"
#include "wend/control/motion_model.hpp"
#include "wend_nav2/planner_settings.hpp"

namespace wend_nav2 {

/// What concerns all controllers.
struct ControlOptions {
  ObstacleRule obstacles = ObstacleRule::automatic;
  bool allow_unknown = true;
  double pose_timeout = 1;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"obstacles",
           "what keeps the robot from obstacles: inscribed (its centre stays out of costs from "
           "253), or footprint and auto (its footprint out of cost 254)"},
          self.obstacles);
    field({"allow_unknown", "whether the robot may drive into unknown cells"}, self.allow_unknown);
    field({"pose_timeout", "age of the robot's pose from which on it stands, s; 0: any age"},
          self.pose_timeout, {0, 3600});
  }

  friend bool operator==(const ControlOptions&, const ControlOptions&) = default;
};

/// The name of the parameter that chooses the controller, and the default.
inline constexpr std::string_view kControllerParameter = "controller";
inline constexpr std::string_view kDefaultController = "pure_pursuit";

/// The parameters of the plugin for one controller.
struct ControllerSchema {
  wend::OptionInfo name = {};                 // which controller
  std::vector<wend::OptionInfo> plugin = {};  // ControlOptions
  std::vector<wend::OptionInfo> robot = {};   // wend::MotionModel
  std::vector<wend::OptionInfo> follower =
      {};  // wend::FollowerOptions, without the tolerances of the goal
  std::vector<wend::OptionInfo> controller = {};  // the controller's own; empty if it is unknown
};

ControllerSchema controller_schema(std::string_view controller);

struct ControlSettings {
  std::string controller{kDefaultController};
  ControlOptions plugin = {};
  wend::MotionModel robot = {};
  wend::FollowerOptions follower = {};
  wend::OptionValues options = {};  // the controller's own
};

/// Settings of all parameters as text. Fails with invalid_option for an unknown controller or name, a value out of
/// range, and a controller that turns in place for a robot that cannot.
wend::Expected<ControlSettings, wend::Error> control_settings_from(
    std::string_view controller, const wend::OptionValues& values);

}  // namespace wend_nav2
