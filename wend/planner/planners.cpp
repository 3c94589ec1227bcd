#include "wend/planner/planners.hpp"

#include <utility>

#include "wend/index/file/index_bytes.hpp"
#include "wend/planner/index_support.hpp"

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

namespace {

Expected<const PlannerInfo*, PlannerError> planner_named(std::string_view name) {
  const PlannerInfo* info = planners().find(name);
  if (info != nullptr) return info;
  return Unexpected<PlannerError>({Status::invalid_option, planners().unknown("planner", name)});
}

}  // namespace

PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options) {
  const auto info = planner_named(name);
  if (!info) return Unexpected<PlannerError>(info.error());
  return (*info)->make(space, options);
}

PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options, IndexBytes index) {
  const auto info = planner_named(name);
  if (!info) return Unexpected<PlannerError>(info.error());
  if (!(*info)->index_support) {
    return Unexpected<PlannerError>(
        {Status::invalid_option, std::string(name) + " does not use an index"});
  }
  return (*info)->index_support->make_planner(space, options, std::move(index));
}

}  // namespace wend
