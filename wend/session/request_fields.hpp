#pragma once

// The list of what front ends set of a PlanRequest by name: flags, keyword arguments, parameters and wend_request_set()
// come from it, and values are checked by it.
//
//   wend::PlanRequest request{{1, 1, 0}, {{{15, 9}}}};
//   const wend::RequestField* const escape = wend::request_field("escape");
//   const auto set = escape->set(request, 0.5, map.frame().resolution);
//
// A new field is a member of PlanRequest and an entry of this list.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/options.hpp"
#include "wend/session/plan_request.hpp"

namespace wend {

/// One field. Its value is a number; that of a flag is 0 or 1.
struct WEND_API RequestField {
  OptionInfo info;        // name, kind, range and help; the default is empty where there is none
  std::string_view unit;  // "m", "rad", "s", or empty
  double default_value;   // NaN where there is none
  /// Puts a valid value into a request with lengths in metres and this resolution.
  void (*put)(PlanRequest& request, double value, double resolution);
  /// The flag of the command line, without its dashes; empty where it says the field in another way.
  std::string flag;

  /// What is wrong with a value, as the options of planners say it. `called` is the name that the user chose; empty: the
  /// first one.
  std::optional<Error> fault_of(double value, std::string_view called = {}) const;

  /// A value as text, "true" or "0.5"; fails with invalid_option.
  Expected<double, Error> number_of(std::string_view text) const;

  /// Sets it in a request whose goals are known, or fails with invalid_option.
  Expected<void, Error> set(PlanRequest& request, double value, double resolution) const;
};

/// All fields, in the order in which front ends show them.
WEND_API std::span<const RequestField> request_fields();

/// The field of that name or alias, or null.
WEND_API const RequestField* request_field(std::string_view name);

/// The error for a name that no field has: invalid_option, with the most similar name.
WEND_API Error unknown_request_field(std::string_view name);

}  // namespace wend
