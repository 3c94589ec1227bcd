#include "wend_ros/option_parameters.hpp"

#include <cmath>

#include "wend/base/parse.hpp"

namespace wend_ros {
namespace {

std::string text_of(XmlRpc::XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value) ? "true" : "false";
    case XmlRpc::XmlRpcValue::TypeInt:
      return std::to_string(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return wend::format_number(static_cast<double>(value));
    case XmlRpc::XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    case XmlRpc::XmlRpcValue::TypeArray: {
      std::string list;
      for (int i = 0; i < value.size(); ++i) list += (i > 0 ? ", " : "") + text_of(value[i]);
      return "[" + list + "]";
    }
    default:
      return "";
  }
}

}  // namespace

std::optional<std::string> parameter_text(const ros::NodeHandle& own, const std::string& name) {
  XmlRpc::XmlRpcValue value;
  if (!own.getParam(name, value)) return std::nullopt;
  return text_of(value);
}

double positive_parameter(const ros::NodeHandle& own, const std::string& name, double otherwise) {
  const double value = own.param(name, otherwise);
  if (value > 0 && std::isfinite(value)) return value;
  ROS_ERROR_STREAM("~" << name << " is " << value << ": a number above 0 expected; it stays "
                       << otherwise);
  return otherwise;
}

wend::OptionValues parameters_of(const ros::NodeHandle& own,
                                 const std::vector<wend::OptionInfo>& schema) {
  wend::OptionValues values;
  for (const wend::OptionInfo& option : schema) {
    if (auto text = parameter_text(own, option.name)) {
      values.emplace_back(option.name, *text);
    } else if (!option.former.empty()) {
      if (auto old = parameter_text(own, option.former)) values.emplace_back(option.former, *old);
    }
  }
  return values;
}

}  // namespace wend_ros
