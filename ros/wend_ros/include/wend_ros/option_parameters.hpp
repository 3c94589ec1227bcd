#pragma once

// A struct of wend's options, read from a node's parameters of the same names: what is not there
// keeps its default, and what is wrong is told by ROS_ERROR and keeps it too.
//
//   const auto limits = wend_ros::options_from_parameters<wend::VelocityLimits>(own);

#include <ros/ros.h>

#include <optional>
#include <string>

#include "wend/base/options.hpp"

namespace wend_ros {

/// A parameter as text, whatever its type: <param name="connectivity" value="4"/> is a number, and
/// the option a choice. A list is "[a, b]". Nothing if the parameter is unset.
std::optional<std::string> parameter_text(const ros::NodeHandle& own, const std::string& name);

/// A number above 0. An invalid one is told by ROS_ERROR, and stays `otherwise`.
double positive_parameter(const ros::NodeHandle& own, const std::string& name, double otherwise);

/// The parameters that a schema names, as far as each alone is right.
wend::OptionValues parameters_of(const ros::NodeHandle& own,
                                 const std::vector<wend::OptionInfo>& schema);

template <class Options>
Options options_from_parameters(const ros::NodeHandle& own) {
  Options options;
  for (const auto& value : parameters_of(own, wend::option_schema<Options>())) {
    wend::OptionValues values{value};
    wend::OptionParser parser(values);
    Options::fields(options, parser);
    if (const auto error = parser.error()) ROS_ERROR_STREAM(error->message);
  }
  return options;
}

}  // namespace wend_ros
