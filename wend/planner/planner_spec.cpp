#include "wend/planner/planner_spec.hpp"

#include <algorithm>

#include "wend/planner/planners.hpp"

namespace wend {

Expected<std::vector<PlannerSpec>, PlannerError> parse_planner_specs(std::string_view list) {
  auto specs = parse_option_specs(list, "planner", planners().names());
  if (!specs) return Unexpected<PlannerError>({Status::invalid_option, specs.error()});
  return *std::move(specs);
}

GridMoves moves_of(const PlannerSpec& planner) {
  const std::vector<OptionInfo> schema = option_schema<GridMoves>();
  OptionValues values;
  for (const auto& value : planner.options) {
    const auto is_it = [&value](const OptionInfo& option) { return option.name == value.first; };
    if (std::any_of(schema.begin(), schema.end(), is_it)) values.push_back(value);
  }
  return parse_options<GridMoves>(values).value_or(GridMoves{});
}

}  // namespace wend
