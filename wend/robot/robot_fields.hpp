#pragma once

// The list of what front ends set by name of a robot, and of what blocks it. The footprint has more shapes than the
// disc that a field can say: parse_footprint() reads them.
//
//   wend::FreeSpaceOptions robot;
//   const auto set = wend::robot_field("clearance_distance")->set(robot, 0.5);
//
// A new field is a member of FreeSpaceOptions and an entry of this list.

#include <span>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/field.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// A field of a robot or of what blocks it, see Field.
using RobotField = Field<FreeSpaceOptions>;

/// All fields, in the order in which front ends show them.
WEND_API std::span<const RobotField> robot_fields();

/// The field of that name or alias, or null.
WEND_API const RobotField* robot_field(std::string_view name);

}  // namespace wend
