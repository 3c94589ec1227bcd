#include "wend/session/shift_text.hpp"

#include <utility>

#include "wend/base/number_text.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {

std::string shift_text(const SnappingError& error, const Units& units) {
  constexpr double kRounding = 1e-9;
  std::string text;
  if (error.distance > kRounding) text = units.length(error.distance);
  if (error.turn > kRounding) {
    if (!text.empty()) text += " and ";
    text += general_text(degrees_from(error.turn), 3) + " degrees";
  }
  return text.empty() ? text : text + " from what was asked";
}

std::string shifts_text(const SnappingError& start, const SnappingError& goal, const Units& units) {
  std::string text;
  for (const auto& [name, error] : {std::pair("the start ", start), std::pair("the goal ", goal)}) {
    const std::string shift = shift_text(error, units);
    if (shift.empty()) continue;
    if (!text.empty()) text += ", ";
    text += name + shift;
  }
  return text;
}

}  // namespace wend
