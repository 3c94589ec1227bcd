// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/request_settings.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>

#include "wend_nav2/field_parameter.hpp"

namespace wend_nav2 {
namespace {

/// Fields that are no parameters: a limit on time is enough, paths come from searches, and `smooth` says what is done
/// with them.
constexpr std::array<std::string_view, 3> kNoParameters{"expansions", "from_field", "straighten"};

/// How a parameter differs from its field, as far as it is not empty.
struct Difference {
  std::string_view field;
  std::string_view name;
  std::string_view default_value;
  std::string_view help;
};
constexpr auto kDifferences = std::to_array<Difference>(
    {{"goal_tolerance", "tolerance", "0.5",
      "how far from a goal that cannot be reached a path may end, m"},
     {"goal_heading_tolerance", "heading_tolerance", "", ""},
     {"time_limit", "", "5", "limit on the search time, s; 0: none"},
     {"nearest_limit", "", "0.5", "how far nearest moves a start or goal at most, m"},
     {"escape", "", "0.25", ""},
     {"keep", "", "",
      "with replan: the share by which another path must be cheaper than what is left of the last "
      "one to be taken"},
     {"spacing", "", "", "distance of the poses of a path, m; 0: that of the costmap's cells"}});

std::string_view either(std::string_view ours, std::string_view listed) {
  return ours.empty() ? listed : ours;
}

wend::OptionInfo as_parameter(const wend::RequestField& field) {
  constexpr double kLargest = 3600;
  wend::OptionInfo option = parameter_of(field.info, kLargest);
  const auto* const own = std::ranges::find(kDifferences, field.info.name, &Difference::field);
  if (own == kDifferences.end()) return option;
  option.name = either(own->name, option.name);
  option.default_value = either(own->default_value, option.default_value);
  option.help = either(own->help, option.help);
  return option;
}

bool is_parameter(const wend::RequestField& field) {
  return std::ranges::find(kNoParameters, field.info.name) == kNoParameters.end();
}

}  // namespace

std::vector<wend::OptionInfo> request_parameters() {
  std::vector<wend::OptionInfo> parameters;
  for (const wend::RequestField& field : wend::request_fields()) {
    if (is_parameter(field)) parameters.push_back(as_parameter(field));
  }
  return parameters;
}

RequestSettings::RequestSettings() {
  for (const wend::RequestField& field : wend::request_fields()) {
    if (!is_parameter(field)) continue;
    const auto value = field.info.number_of(as_parameter(field).default_value);
    values_.emplace_back(&field, value.value_or(0));
  }
}

wend::Expected<bool, wend::Error> RequestSettings::set(std::string_view parameter,
                                                       std::string_view value) {
  for (auto& [field, number] : values_) {
    const wend::OptionInfo option = as_parameter(*field);
    if (option.name != parameter) continue;
    if (const std::string fault = wend::option_text::fault_of(option, value); !fault.empty()) {
      return wend::Unexpected<wend::Error>(wend::option_text::option_error(option.name, fault));
    }
    number = field->info.number_of(value).value_or(number);
    return true;
  }
  return false;
}

double RequestSettings::operator[](std::string_view field) const {
  const auto found = std::ranges::find_if(
      values_, [&](const auto& value) { return value.first->info.name == field; });
  assert(found != values_.end());
  return found->second;
}

void RequestSettings::put(wend::PlanRequest& request, double resolution) const {
  for (const auto& [field, value] : values_) field->put(request, value, resolution);
}

}  // namespace wend_nav2
