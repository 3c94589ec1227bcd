#pragma once

// For planners without options.

#include <optional>

#include "wend/base/options.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

/// Why options cannot be taken, if there are any.
inline std::optional<PlannerError> refused_options(const OptionValues& values) {
  if (values.empty()) return std::nullopt;
  return PlannerError{Status::invalid_option,
                      option_text::unknown_option(values.front().first, {}).message()};
}

}  // namespace wend
