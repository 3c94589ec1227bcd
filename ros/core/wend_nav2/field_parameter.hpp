// SPDX-License-Identifier: Apache-2.0
#pragma once

// A field of a request or a robot as a parameter.

#include <algorithm>
#include <string>

#include "wend/base/field.hpp"

namespace wend_nav2 {

/// Numbers up to `greatest`, which people set with a slider; the help ends with the unit.
inline wend::OptionInfo parameter_of(const wend::FieldInfo& field, double greatest) {
  wend::OptionInfo option = field.option();
  option.greatest = std::min(option.greatest, greatest);
  if (!field.unit.empty()) option.help += ", " + std::string(field.unit);
  return option;
}

}  // namespace wend_nav2
