#include "wend/planner/planners.hpp"

namespace wend {

#define WEND_PLANNER(name) PlannerInfo name##_planner();
#include "wend/planner/planners.def"
#undef WEND_PLANNER

const Registry<PlannerInfo>& planners() {
  static const Registry<PlannerInfo> registry({
#define WEND_PLANNER(name) name##_planner(),
#include "wend/planner/planners.def"
#undef WEND_PLANNER
  });
  return registry;
}

std::vector<std::string> planner_names(Motion motion) {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    if (info.motion == motion) names.push_back(info.name);
  }
  return names;
}

PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options) {
  const PlannerInfo* info = planners().find(name);
  if (info == nullptr) {
    return Unexpected<PlannerError>({Status::invalid_option, planners().unknown("planner", name)});
  }
  return info->make(space, options);
}

}  // namespace wend
