// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/control_settings.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "wend/control/controller.hpp"

namespace wend_nav2 {
namespace {

// The goal checker says these.
constexpr std::array<std::string_view, 2> kOfGoal{"goal_tolerance", "heading_tolerance"};

bool has(const std::vector<wend::OptionInfo>& options, std::string_view name) {
  return std::ranges::find(options, name, &wend::OptionInfo::name) != options.end();
}

/// The options that one of the schema's lists has.
wend::OptionValues part_of(const wend::OptionValues& values,
                           const std::vector<wend::OptionInfo>& options) {
  wend::OptionValues part;
  std::ranges::copy_if(values, std::back_inserter(part),
                       [&](const auto& value) { return has(options, value.first); });
  return part;
}

}  // namespace

ControllerSchema controller_schema(std::string_view controller) {
  const wend::ControllerInfo* info = wend::controllers().find(controller);
  ControllerSchema schema{
      .name = {.name = std::string(kControllerParameter),
               .aliases = {},
               .kind = wend::OptionKind::choice,
               .default_value = std::string(kDefaultController),
               .choices = wend::controllers().names(),
               .help = "name of the controller"},
      .plugin = wend::option_schema<ControlOptions>(),
      .robot = wend::option_schema<wend::MotionModel>(),
      .follower = wend::option_schema<wend::FollowerOptions>(),
      .controller = info == nullptr ? std::vector<wend::OptionInfo>() : info->options};
  std::erase_if(schema.follower, [](const wend::OptionInfo& option) {
    return std::ranges::find(kOfGoal, option.name) != kOfGoal.end();
  });
  return schema;
}

wend::Expected<ControlSettings, wend::Error> control_settings_from(
    std::string_view controller, const wend::OptionValues& values) {
  const wend::ControllerInfo* info = wend::controllers().find(controller);
  if (info == nullptr) {
    return wend::failure(wend::Status::invalid_option,
                         wend::controllers().unknown("controller", controller), "controller");
  }
  const ControllerSchema schema = controller_schema(controller);
  wend::OptionValues of_plugin;  // and what nothing knows
  for (const auto& value : values) {
    if (has(schema.robot, value.first) || has(schema.follower, value.first) ||
        has(schema.controller, value.first)) {
      continue;
    }
    of_plugin.push_back(value);
  }
  auto plugin = wend::parse_options<ControlOptions>(of_plugin);
  if (!plugin) return wend::Unexpected<wend::Error>(std::move(plugin.error()));
  auto robot = wend::parse_options<wend::MotionModel>(part_of(values, schema.robot));
  if (!robot) return wend::Unexpected<wend::Error>(std::move(robot.error()));
  auto follower = wend::parse_options<wend::FollowerOptions>(part_of(values, schema.follower));
  if (!follower) return wend::Unexpected<wend::Error>(std::move(follower.error()));
  ControlSettings settings{.controller = std::string(controller),
                           .plugin = *plugin,
                           .robot = *robot,
                           .follower = *follower,
                           .options = part_of(values, schema.controller)};
  settings.follower.turns_in_place = robot->turning_radius() == 0;
  const auto made = info->make(settings.options);
  if (!made) return wend::Unexpected<wend::Error>(made.error());
  if (const auto fault = wend::why_unfit(*info, *robot)) {
    return wend::failure(wend::Status::invalid_option, *fault, "controller");
  }
  return settings;
}

}  // namespace wend_nav2
