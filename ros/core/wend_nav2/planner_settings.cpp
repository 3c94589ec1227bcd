// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/planner_settings.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "wend/io/primitives/load_primitives.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend_nav2 {
namespace {

const wend::OptionInfo* find(const std::vector<wend::OptionInfo>& options, std::string_view name) {
  const auto found = std::ranges::find(options, name, &wend::OptionInfo::name);
  return found == options.end() ? nullptr : &*found;
}

/// Would the planner refuse these options, which are within their ranges one by one? It is made on a map of one cell.
std::optional<wend::Error> refusal_of(const wend::PlannerInfo& planner,
                                      const wend::OptionValues& options) {
  const auto map = wend::make_grid_map(wend::Grid<wend::CellState>(1, 1, wend::CellState::free));
  if (!map) return std::nullopt;
  const auto space = wend::make_free_space(*map);
  if (!space) return std::nullopt;
  const auto made = planner.make(*space, options);
  const bool refused = !made && made.error().status == wend::Status::invalid_option;
  return refused ? std::optional(made.error()) : std::nullopt;
}

}  // namespace

PlannerSchema planner_schema(std::string_view planner) {
  const wend::PlannerInfo* info = wend::planners().find(planner);
  std::vector<wend::OptionInfo> plugin = wend::option_schema<PluginOptions>();
  for (wend::OptionInfo& parameter : request_parameters()) plugin.push_back(std::move(parameter));
  return {.name = {.name = std::string(kPlannerParameter),
                   .aliases = {},
                   .kind = wend::OptionKind::choice,
                   .default_value = std::string(kDefaultPlanner),
                   .choices = wend::planners().names(),
                   .help = "name of the planner"},
          .plugin = std::move(plugin),
          .planner = info == nullptr ? std::vector<wend::OptionInfo>() : info->options};
}

wend::Expected<PlannerSettings, wend::Error> settings_from(std::string_view planner,
                                                           const wend::OptionValues& values,
                                                           std::string_view primitives) {
  if (wend::planners().find(planner) == nullptr) {
    return wend::failure(wend::Status::invalid_option, wend::planners().unknown("planner", planner),
                         "planner");
  }
  const PlannerSchema schema = planner_schema(planner);
  PlannerSettings settings{.planner = std::string(planner)};
  wend::OptionValues of_plugin;
  for (const auto& [name, value] : values) {
    const wend::OptionInfo* own = find(schema.planner, name);
    if (own == nullptr) {
      const auto set = settings.request.set(name, value);
      if (!set) return wend::Unexpected<wend::Error>(set.error());
      if (!*set) of_plugin.emplace_back(name, value);
      continue;
    }
    if (const std::string fault = wend::option_text::fault_of(*own, value); !fault.empty()) {
      return wend::Unexpected<wend::Error>(wend::option_text::option_error(name, fault));
    }
    // Some defaults stand for what the planner chooses by itself.
    if (value != own->default_value) settings.options.emplace_back(name, value);
  }
  if (auto refusal = refusal_of(*wend::planners().find(planner), settings.options)) {
    return wend::Unexpected<wend::Error>(*std::move(refusal));
  }
  auto plugin = wend::parse_options<PluginOptions>(of_plugin);
  if (!plugin) return wend::Unexpected<wend::Error>(std::move(plugin.error()));
  settings.plugin = *plugin;
  if (!primitives.empty()) {
    auto loaded = wend::load_primitives(primitives);
    if (!loaded) return wend::Unexpected<wend::Error>(std::move(loaded.error()));
    settings.primitives = *std::move(loaded);
  }
  return settings;
}

}  // namespace wend_nav2
