#include "cli/output/explanations.hpp"

#include <fmt/format.h>

#include "cli/output/terminal.hpp"

namespace wend::cli {

Hints command_line_hints() {
  return {.unknown_free = "--unknown free",
          .outside_free = "--outside free",
          .squeeze = "--connectivity 8 --corner-rule both",
          .robot_radius = "--robot-radius",
          .nearest = "--nearest",
          .nearest_limit = "--nearest-limit",
          .escape = "--escape",
          .explain = "`wend explain` shows where",
          .limit_expansions = "--limit-expansions",
          .limit_seconds = "--limit-time",
          .limit_steps = "--max-steps",
          .turning_radius = "--turning-radius",
          .allow_reverse = "--allow-reverse"};
}

std::string explanation_line(std::string_view name, const std::string& what) {
  constexpr int kNameColumns = 18;
  return folded(fmt::format("{:<{}}{}", name, kNameColumns, what), detect_screen().columns,
                kNameColumns) +
         "\n";
}

Explainer explainer_for(const FreeSpace& space, const Coordinates& coordinates, GridMoves moves) {
  return {space, coordinates, moves, command_line_hints()};
}

}  // namespace wend::cli
