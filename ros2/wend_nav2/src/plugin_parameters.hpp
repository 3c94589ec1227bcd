// SPDX-License-Identifier: Apache-2.0
#pragma once

// PluginParameters: the parameters of a plugin, `<name>.<option>`, declared from schemas, with ranges and help. While
// the node runs, a change that does not fit is refused, and one that does is kept for the next call of the plugin. Knows
// no Nav2: wend_ros uses it for its node, too.

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <rclcpp/rclcpp.hpp>

#include "wend/base/options.hpp"

namespace wend_nav2 {

class PluginParameters {
 public:
  using NodeParameters = rclcpp::node_interfaces::NodeParametersInterface;

  /// What is wrong with these values, empty if nothing is.
  using Check = std::function<std::string(const wend::OptionValues&)>;

  /// Of a node; without a plugin's name, the node's own.
  PluginParameters(const NodeParameters::SharedPtr& node, const std::string& plugin)
      : node_(node), prefix_(plugin.empty() ? "" : plugin + '.') {}

  /// A parameter that is text and stays as it is while the plugin is configured.
  std::string fixed(const std::string& name, const std::string& default_value,
                    const std::string& help);

  /// Declares what is not there yet, and returns all values. Throws what rclcpp throws for a value that is out of
  /// range or of another type.
  wend::OptionValues declare(const std::vector<wend::OptionInfo>& options);

  /// From now on checks what is set.
  void watch(Check check);
  void stop_watching();

  /// The values, if any have changed since they were last asked for.
  std::optional<wend::OptionValues> changed();

 private:
  rcl_interfaces::msg::SetParametersResult check_change(
      const std::vector<rclcpp::Parameter>& parameters) const;
  void take_change(const std::vector<rclcpp::Parameter>& parameters);
  wend::OptionValues with(const std::vector<rclcpp::Parameter>& parameters, bool& touched) const;

  std::weak_ptr<NodeParameters> node_;
  std::string prefix_;
  Check check_;
  mutable std::mutex mutex_;  // guards what follows
  wend::OptionValues values_;
  bool is_changed_ = false;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr on_set_;
  rclcpp::node_interfaces::PostSetParametersCallbackHandle::SharedPtr post_set_;
};

}  // namespace wend_nav2
