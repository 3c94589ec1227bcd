// SPDX-License-Identifier: Apache-2.0
#pragma once

// PlannerSettings: what users set of wend_nav2/Planner, from the planners' own schemas. Knows no ROS.
//
//   const PlannerSchema schema = planner_schema("astar");
//   for (const wend::OptionInfo& option : schema.plugin) declare(option);   // of every planner
//   for (const wend::OptionInfo& option : schema.planner) declare(option);  // of astar
//   const auto settings = settings_from("astar", values);

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/choice.hpp"
#include "wend/base/error.hpp"
#include "wend/base/options.hpp"
#include "wend/robot/motion_primitives.hpp"
#include "wend_nav2/request_settings.hpp"

namespace wend_nav2 {

/// What keeps the robot from obstacles.
enum class ObstacleRule {
  automatic,  // footprint
  inscribed,  // its centre may not be where costs are 253 or 254; as NavFn and Smac 2D do
  footprint,  // its footprint may not touch cells of cost 254
};

constexpr std::array<wend::Choice<ObstacleRule>, 3> choice_names(ObstacleRule) {
  return {{{"auto", ObstacleRule::automatic},
           {"inscribed", ObstacleRule::inscribed},
           {"footprint", ObstacleRule::footprint}}};
}

/// What concerns all planners, besides the request.
struct PluginOptions {
  ObstacleRule obstacles = ObstacleRule::automatic;
  bool allow_unknown = true;
  double cost_factor = 4;
  bool smooth = true;
  bool replan = false;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"obstacles",
           "what keeps the robot from obstacles: inscribed (its centre stays out of costs from "
           "253), or footprint and auto (its footprint out of cost 254)"},
          self.obstacles);
    field({"allow_unknown", "whether the robot may drive into unknown cells"}, self.allow_unknown);
    field({"cost_factor", "what the cost 252 of a cell adds to a price of 1 for a metre"},
          self.cost_factor, {0, 1e4});
    field({"smooth", "smooth the paths of planners on cells"}, self.smooth);
    field({"replan", "keep what a search found for the next call, and repair it after changes"},
          self.replan);
  }

  friend bool operator==(const PluginOptions&, const PluginOptions&) = default;
};

/// The name of the parameter that chooses the planner, of the one with its motion primitives, and the default.
inline constexpr std::string_view kPlannerParameter = "planner";
inline constexpr std::string_view kPrimitivesParameter = "primitives";
inline constexpr std::string_view kDefaultPlanner = "astar";

/// The parameters of the plugin for one planner.
struct PlannerSchema {
  wend::OptionInfo name = {};                  // which planner, one of all
  std::vector<wend::OptionInfo> plugin = {};   // PluginOptions and request_parameters()
  std::vector<wend::OptionInfo> planner = {};  // the planner's own; empty if it is unknown
};

PlannerSchema planner_schema(std::string_view planner);

struct PlannerSettings {
  std::string planner{kDefaultPlanner};
  PluginOptions plugin = {};
  RequestSettings request = {};
  wend::OptionValues options = {};  // the planner's own that are not at their defaults
  std::optional<wend::MotionPrimitives> primitives = {};  // for `lattice`

  friend bool operator==(const PlannerSettings&, const PlannerSettings&) = default;
};

/// Settings of all parameters as text. `primitives` is a file; empty: none. Fails with invalid_option for an unknown
/// planner or name and a value out of range, and as wend::load_primitives() does.
wend::Expected<PlannerSettings, wend::Error> settings_from(std::string_view planner,
                                                           const wend::OptionValues& values,
                                                           std::string_view primitives = {});

}  // namespace wend_nav2
