#include "wend/planner/planners.hpp"

#include <algorithm>

#include "wend/index/file/index_bytes.hpp"
#include "wend/planner/index_support.hpp"

namespace wend {

#define WEND_PLANNER(name) PlannerInfo name##_planner();
#include "wend/planner/planners.def"

const Registry<PlannerInfo>& planners() {
  static const Registry<PlannerInfo> registry({
#define WEND_PLANNER(name) name##_planner(),
#include "wend/planner/planners.def"
  });
  return registry;
}

std::vector<std::string> planner_names(StateKind state_kind) {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    if (info.state_kind == state_kind) names.push_back(info.name);
  }
  return names;
}

namespace {

Expected<const PlannerInfo*, Error> planner_named(std::string_view name) {
  const PlannerInfo* info = planners().find(name);
  if (info != nullptr) return info;
  return failure(Status::invalid_option, planners().unknown("planner", name));
}

}  // namespace

PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options) {
  const auto info = planner_named(name);
  if (!info) return Unexpected<Error>(info.error());
  return (*info)->make(space, options);
}

PlannerResult make_planner(std::string_view name, const FreeSpace& space,
                           const OptionValues& options, IndexBytes index) {
  const auto info = planner_named(name);
  if (!info) return Unexpected<Error>(info.error());
  if (!(*info)->index_support) {
    return failure(Status::invalid_option, std::string(name) + " does not use an index");
  }
  return (*info)->index_support->make_planner(space, options, std::move(index));
}

std::optional<Error> refused_terrain(std::string_view planner, const FreeSpace& space) {
  if (space.uniform_terrain()) return std::nullopt;
  return Error{Status::unsupported_map,
               std::string(planner) +
                   " supports uniform terrain only; this map has terrain or clearance costs"};
}

std::optional<Error> refused_options(const OptionValues& values) {
  if (values.empty()) return std::nullopt;
  return Error{Status::invalid_option,
               "unknown option '" + values.front().first + "': this planner has no options"};
}

Expected<std::vector<PlannerSpec>, Error> parse_planner_specs(std::string_view list) {
  return parse_option_specs(list, "planner", planners().names());
}

std::string_view terrain_in_words(const PlannerInfo& planner) {
  if (planner.plans_on_terrain) return "costs count";
  constexpr int kSide = 2;
  const GridMap rough = *make_grid_map(Grid<CellState>(kSide, kSide, CellState::free), {},
                                       Grid<double>(kSide, kSide, 2));
  return planner.make(*make_free_space(rough), {}) ? "ignored" : "refused";
}

}  // namespace wend
