#pragma once

// What is wrong with a length that a function of paths takes: a window, a tolerance, a spacing.

#include <cmath>
#include <optional>
#include <string>

#include "wend/base/error.hpp"
#include "wend/base/parse.hpp"

namespace wend {

/// invalid_option for a length that is not finite or negative; nothing for others.
inline std::optional<Error> fault_of_length(const std::string& name, double cells) {
  if (cells >= 0 && std::isfinite(cells)) return std::nullopt;
  return Error{Status::invalid_option,
               name + " is " + format_number(cells) + ": a finite number of cells from 0 expected",
               name};
}

}  // namespace wend
