#pragma once

// Parameters: what people can set of the planner's node, made at run time from the planners' own
// option schemas: on the parameter server when the node starts, and by dynamic_reconfigure's
// messages while it runs (rqt_reconfigure, dynparam, or any client).
//
// Every option of a planner is a parameter of the same name, and its aliases too (`lambda` is
// `weight`); planners that do not have it do not get it. Then there is what concerns them all:
//
//   planner         which one                robot_radius   metres
//   footprint       [[x, y], ...] or "rect:LENGTHxWIDTH[,AHEAD]", metres: the robot's polygon, in place of
//                   robot_radius; its base point may lie outside
//   primitives      file of the robot's motion primitives, for the planner lattice
//   unknown_free    drive into unknown       clearance_distance      metres
//   clearance_cost  what cells near obstacles cost more
//   outside         blocked or free: may the robot's disc hang over the map's edge?
//   time_limit      s, 0: none               rough          values below the threshold cost more
//   cost_factor     how much more
//   goal_tolerance  m, where a path may end  goal_heading_tolerance   rad
//   nearest         moves blocked ends       nearest_limit      m, how far
//   escape          m, the longest way out   closest            ends near goals that no path reaches
//   replan_on_change                         never, ahead or always
//   smooth, smooth_alpha, smooth_beta        smooth the path

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/options.hpp"
#include "wend/robot/footprint.hpp"
#include "wend/robot/motion_primitives.hpp"
#include "wend/robot/robot_fields.hpp"
#include "wend/session/request_fields.hpp"
#include "wend_ros/replanning.hpp"

namespace wend_ros {

/// The fields of a request that are parameters of the same names.
std::vector<const wend::RequestField*> request_parameters();

/// The same of a robot and of what blocks it.
std::vector<const wend::RobotField*> robot_parameters();

class Parameters {
 public:
  /// All at their defaults.
  Parameters();

  const std::vector<wend::OptionInfo>& schema() const { return schema_; }

  /// Sets one by its name or an alias; what is wrong with the value, empty if nothing is.
  std::string set(std::string_view name, std::string_view value);

  /// As text: "1.5", "true", "octile".
  const std::string& text(std::string_view name) const;
  double number(std::string_view name) const;
  bool flag(std::string_view name) const;

  /// When a change of the map is a reason to plan again.
  ReplanOnChange replan_on_change() const;

  /// The robot's shape: `footprint` if it is set, else a disc of `robot_radius`.
  wend::Footprint footprint() const;

  /// Those of the file `primitives`, if it is set.
  const std::optional<wend::MotionPrimitives>& primitives() const { return primitives_; }

  /// Those of a planner that somebody has set, to values that it takes.
  wend::OptionValues options_of(std::string_view planner) const;

  dynamic_reconfigure::ConfigDescription description() const;
  dynamic_reconfigure::Config config() const;

  /// Takes what it can, all else stays; what is wrong, a line for each value refused.
  std::vector<std::string> apply(const dynamic_reconfigure::Config& config);

 private:
  void read_primitives();
  const wend::OptionInfo* find(std::string_view name) const;
  dynamic_reconfigure::Config config_of(const std::vector<std::string>& values) const;

  std::vector<wend::OptionInfo> schema_;
  std::vector<std::string> values_;  // of each in the schema
  std::optional<wend::MotionPrimitives> primitives_;
};

}  // namespace wend_ros
