#include "wend/session/leeway.hpp"

#include <cmath>
#include <string>

#include "wend/base/parse.hpp"

namespace wend {

std::optional<Error> fault_of(const Leeway& leeway) {
  const auto wrong = [](const std::string& name, double value) {
    return Error{Status::invalid_option,
                 name + " is " + format_number(value) + ": a number of metres from 0 expected",
                 name};
  };
  if (!(leeway.escape >= 0) || std::isinf(leeway.escape)) return wrong("escape", leeway.escape);
  if (leeway.nearest_limit && !(*leeway.nearest_limit >= 0)) {
    return wrong("nearest_limit", *leeway.nearest_limit);
  }
  return std::nullopt;
}

}  // namespace wend
