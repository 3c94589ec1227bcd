#pragma once

// Field: what front ends set of a value by its name. A list of fields has the names, units, ranges, defaults and help of
// what a request (session/request_fields.hpp) or a robot (robot/robot_fields.hpp) has: flags, keyword arguments,
// parameters and the C interface come from it, and values are checked by it.
//
//   wend::FreeSpaceOptions robot;
//   const auto set = wend::robot_field("clearance_distance")->set(robot, 0.5);

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/options.hpp"

namespace wend {

/// What a field is. Its value is a number from 0 on; that of a flag is 0 or 1, that of a choice its place among the
/// choices, from 1 on, or 0 for what it is if nobody chooses.
struct WEND_API FieldInfo {
  std::string_view name;                         // as users type it
  OptionKind kind;                               // the type of its value
  std::string_view unit;                         // "m", "rad", "s", or empty
  double greatest;                               // the largest valid value
  double default_value;                          // NaN where there is none
  std::string_view help;                         // without a full stop
  std::string_view alias = {};                   // another name, or empty
  std::array<std::string_view, 2> choices = {};  // of a choice
  std::string_view former = {};                  // an old name: parsed, but not shown

  /// Is this its name, or one of the others?
  bool is_called(std::string_view typed) const {
    return typed == name || (!typed.empty() && (typed == alias || typed == former));
  }

  /// The field as planners have options; the default is empty where there is none.
  OptionInfo option() const;

  /// What is wrong with a value, as the options of planners say it. `called` is the name that the user chose; empty: the
  /// first one.
  std::optional<Error> fault_of(double value, std::string_view called = {}) const;

  /// A value as text, "true", "0.5" or "blocked"; fails with invalid_option.
  Expected<double, Error> number_of(std::string_view text) const;
};

/// A field of a target, and how it is set.
template <class Target>
struct Field {
  FieldInfo info;  // what front ends show of it
  /// Puts a valid value into a target with lengths in metres, on a map of this resolution.
  void (*put)(Target& target, double value, double resolution);

  /// Sets it, or fails with invalid_option.
  Expected<void, Error> set(Target& target, double value, double resolution = 1) const {
    if (auto fault = info.fault_of(value)) return Unexpected<Error>(*std::move(fault));
    put(target, value, resolution);
    return {};
  }
};

/// The field of that name or alias, or null.
template <class Target>
const Field<Target>* find_field(std::span<const Field<Target>> fields, std::string_view name) {
  for (const Field<Target>& field : fields) {
    if (field.info.is_called(name)) return &field;
  }
  return nullptr;
}

}  // namespace wend
