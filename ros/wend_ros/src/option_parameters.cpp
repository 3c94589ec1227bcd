#include "wend_ros/option_parameters.hpp"

#include "wend/base/parse.hpp"

namespace wend_ros {

std::optional<std::string> parameter_text(const ros::NodeHandle& own, const std::string& name) {
  XmlRpc::XmlRpcValue value;
  if (!own.getParam(name, value)) return std::nullopt;
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value) ? "true" : "false";
    case XmlRpc::XmlRpcValue::TypeInt:
      return std::to_string(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return wend::format_number(static_cast<double>(value));
    case XmlRpc::XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    default:
      return "";
  }
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
