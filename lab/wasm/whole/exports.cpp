// What the page calls of the whole module only.

#include "lab/wasm/exchange.hpp"
#include "lab/wasm/whole/registry_text.hpp"

namespace {

using wend::lab::input_text;
using wend::lab::lab;
using wend::lab::output;

}  // namespace

WEND_LAB_EXPORT(registry) void lab_registry() { output() = wend::lab::registry_text(); }

WEND_LAB_EXPORT(widest)
void lab_widest(double start_x, double start_y, double goal_x, double goal_y) {
  output() = lab().widest({start_x, start_y}, {goal_x, goal_y});
}

/// The input has the controller, then the robot, then the simulation.
WEND_LAB_EXPORT(drive)
void lab_drive(std::size_t controller, std::size_t robot, std::size_t simulation) {
  const std::string names(input_text(0, controller + robot + simulation));
  const std::string_view text(names);
  output() = lab().drive(text.substr(0, controller), text.substr(controller, robot),
                         text.substr(controller + robot));
}
