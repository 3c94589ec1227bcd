#include "docs/planner_page/family.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "wend/index/file/index_bytes.hpp"
#include "wend/planner/planners.hpp"

namespace wend::planner_page {
namespace {

constexpr std::array<std::string_view, 2> kVariants{"astar:weight=2", "astar:heuristic=euclidean"};

PlannerSpec spec_of(const std::string& text) {
  auto specs = parse_planner_specs(text);
  assert(specs && specs->size() == 1);
  return specs->front();
}

bool has_option(const PlannerInfo& planner, std::string_view name) {
  return std::any_of(planner.options.begin(), planner.options.end(),
                     [name](const OptionInfo& option) { return option.name == name; });
}

/// What looks its answers up has nothing to show of a search.
bool searches(const PlannerInfo& planner) {
  return planner.motion == Motion::cells && !planner.index_support;
}

}  // namespace

std::vector<Configuration> configurations(std::string_view option) {
  std::vector<std::string> roles;
  for (const PlannerInfo& planner : planners()) {
    if (searches(planner) && planner.guarantee != Guarantee::none) {
      roles.push_back(planner.name);
    }
  }
  roles.insert(roles.end(), kVariants.begin(), kVariants.end());

  const std::string_view name = option.substr(0, option.find('='));
  std::vector<Configuration> all;
  for (const std::string& role : roles) {
    const PlannerSpec plain = spec_of(role);
    if (option.empty()) {
      all.push_back({role, plain});
    } else if (has_option(*planners().find(plain.name), name)) {
      const char separator = plain.options.empty() ? ':' : ',';
      all.push_back({role, spec_of(role + separator + std::string(option))});
    }
  }
  return all;
}

std::vector<Configuration> those_that_take(const FreeSpace& space,
                                           std::vector<Configuration> configurations) {
  std::erase_if(configurations, [&](const Configuration& each) {
    return !planners().find(each.spec.name)->make(space, each.spec.options);
  });
  return configurations;
}

std::vector<Configuration> all_planners() {
  std::vector<Configuration> all;
  for (const PlannerInfo& planner : planners()) {
    if (searches(planner)) all.push_back({planner.name, spec_of(planner.name)});
  }
  return all;
}

}  // namespace wend::planner_page
