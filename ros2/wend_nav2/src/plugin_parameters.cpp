// SPDX-License-Identifier: Apache-2.0
#include "plugin_parameters.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "wend/base/parse.hpp"

namespace wend_nav2 {
namespace {

rcl_interfaces::msg::ParameterDescriptor descriptor_of(const wend::OptionInfo& option) {
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = option.help;
  // "connectivity: 8" is a number to YAML and a choice to planners, and "weight: 2" is a whole one.
  descriptor.dynamic_typing = true;
  if (option.kind == wend::OptionKind::integer) {
    auto& range = descriptor.integer_range.emplace_back();
    range.from_value = static_cast<std::int64_t>(option.least);
    range.to_value = static_cast<std::int64_t>(option.greatest);
  }
  if (option.kind == wend::OptionKind::number) {
    auto& range = descriptor.floating_point_range.emplace_back();
    range.from_value = option.least;
    range.to_value = option.greatest;
  }
  for (const std::string& choice : option.choices) {
    descriptor.additional_constraints +=
        (descriptor.additional_constraints.empty() ? "one of: " : ", ") + choice;
  }
  return descriptor;
}

rclcpp::ParameterValue default_of(const wend::OptionInfo& option) {
  switch (option.kind) {
    case wend::OptionKind::flag:
      return rclcpp::ParameterValue(option.default_value == "true");
    case wend::OptionKind::integer:
      return rclcpp::ParameterValue(
          wend::parse_integer<std::int64_t>(option.default_value).value_or(0));
    case wend::OptionKind::number:
      return rclcpp::ParameterValue(wend::parse_number(option.default_value).value_or(0));
    case wend::OptionKind::choice:
      break;
  }
  return rclcpp::ParameterValue(option.default_value);
}

std::string text_of(const rclcpp::ParameterValue& value) {
  switch (value.get_type()) {
    case rclcpp::ParameterType::PARAMETER_BOOL:
      return value.get<bool>() ? "true" : "false";
    case rclcpp::ParameterType::PARAMETER_INTEGER:
      return std::to_string(value.get<std::int64_t>());
    case rclcpp::ParameterType::PARAMETER_DOUBLE:
      return wend::format_number(value.get<double>());
    case rclcpp::ParameterType::PARAMETER_STRING:
      return value.get<std::string>();
    default:
      return rclcpp::to_string(value);
  }
}

}  // namespace

std::string PluginParameters::fixed(const std::string& name, const std::string& default_value,
                                    const std::string& help) {
  const auto node = node_.lock();
  const std::string full = prefix_ + name;
  if (!node->has_parameter(full)) {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = help;
    descriptor.read_only = true;
    node->declare_parameter(full, rclcpp::ParameterValue(default_value), descriptor);
  }
  return text_of(node->get_parameter(full).get_parameter_value());
}

wend::OptionValues PluginParameters::declare(const std::vector<wend::OptionInfo>& options) {
  const auto node = node_.lock();
  const std::lock_guard lock(mutex_);
  for (const wend::OptionInfo& option : options) {
    const std::string full = prefix_ + option.name;
    if (!node->has_parameter(full)) {
      node->declare_parameter(full, default_of(option), descriptor_of(option));
    }
    values_.emplace_back(option.name, text_of(node->get_parameter(full).get_parameter_value()));
  }
  return values_;
}

void PluginParameters::watch(Check check) {
  const auto node = node_.lock();
  check_ = std::move(check);
  on_set_ = node->add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter>& set) { return check_change(set); });
  post_set_ = node->add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter>& set) { take_change(set); });
}

void PluginParameters::stop_watching() {
  const auto node = node_.lock();
  if (node && on_set_) node->remove_on_set_parameters_callback(on_set_.get());
  if (node && post_set_) node->remove_post_set_parameters_callback(post_set_.get());
  on_set_.reset();
  post_set_.reset();
}

std::optional<wend::OptionValues> PluginParameters::changed() {
  const std::lock_guard lock(mutex_);
  if (!std::exchange(is_changed_, false)) return std::nullopt;
  return values_;
}

/// The values as they would be; `touched` if any of them is set.
wend::OptionValues PluginParameters::with(const std::vector<rclcpp::Parameter>& parameters,
                                          bool& touched) const {
  const std::lock_guard lock(mutex_);
  wend::OptionValues values = values_;
  for (const rclcpp::Parameter& parameter : parameters) {
    for (auto& [name, value] : values) {
      if (parameter.get_name() != prefix_ + name) continue;
      value = text_of(parameter.get_parameter_value());
      touched = true;
    }
  }
  return values;
}

rcl_interfaces::msg::SetParametersResult PluginParameters::check_change(
    const std::vector<rclcpp::Parameter>& parameters) const {
  rcl_interfaces::msg::SetParametersResult result;
  bool touched = false;
  const wend::OptionValues values = with(parameters, touched);
  if (touched) result.reason = check_(values);
  result.successful = result.reason.empty();
  return result;
}

void PluginParameters::take_change(const std::vector<rclcpp::Parameter>& parameters) {
  bool touched = false;
  wend::OptionValues values = with(parameters, touched);
  if (!touched) return;
  const std::lock_guard lock(mutex_);
  values_ = std::move(values);
  is_changed_ = true;
}

}  // namespace wend_nav2
