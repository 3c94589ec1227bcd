#include "cli/arguments/planner_argument.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/exit_code.hpp"
#include "wend/base/parse.hpp"
#include "wend/planner/lattice/car_planner.hpp"
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

int unit_of(const PlannerSpec& planner, const Frame& frame) {
  std::int64_t unit = 1;
  for (const auto& [name, value] : planner.options) {
    if (name == "lattice_resolution" || name == "unit") {
      unit = parse_integer<int>(value).value_or(1);
    }
    if (name == "turning_radius") unit = unit_for(parse_number(value).value_or(0), frame);
  }
  return static_cast<int>(std::max<std::int64_t>(unit, 1));
}

bool has_option(const std::vector<OptionInfo>& options, std::string_view name) {
  return std::ranges::find(options, name, &OptionInfo::name) != options.end();
}

}  // namespace wend::cli
