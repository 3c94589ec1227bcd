#include "planner_argument.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "exit_code.hpp"
#include "wend/base/parse.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

std::vector<PlannerSpec> parse_planners(const std::string& text) {
  auto specs = parse_planner_specs(text);
  if (!specs) throw InputError(specs.error().message());
  return *std::move(specs);
}

PlannerSpec parse_planner(const std::string& text) {
  const std::vector<PlannerSpec> specs = parse_planners(text);
  if (specs.size() > 1) throw InputError(fmt::format("--planner {}: name one planner", text));
  return specs.front();
}

const PlannerInfo& info_of(const PlannerSpec& planner) { return *planners().find(planner.name); }

int unit_of(const PlannerSpec& planner) {
  int unit = 1;
  for (const auto& [name, value] : planner.options) {
    if (name == "unit") unit = parse_integer<int>(value).value_or(1);
  }
  return std::max(unit, 1);
}

}  // namespace wend::cli
