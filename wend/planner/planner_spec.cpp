#include "wend/planner/planner_spec.hpp"

#include "wend/planner/planners.hpp"

namespace wend {

Expected<std::vector<PlannerSpec>, PlannerError> parse_planner_specs(std::string_view list) {
  auto specs = parse_option_specs(list, "planner", planners());
  if (!specs) return Unexpected<PlannerError>({Status::invalid_option, specs.error()});
  return *std::move(specs);
}

}  // namespace wend
