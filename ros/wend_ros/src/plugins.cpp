#include "wend_ros/plugins.hpp"

#include <sstream>

#include "wend/plugin/load_planners.hpp"

namespace wend_ros {
namespace {

using Files = wend::Expected<std::vector<std::string>, std::string>;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n") + 1 - first);
}

std::vector<std::string> files_in(const std::string& text) {
  std::vector<std::string> files;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    std::string file = trimmed(word);
    if (!file.empty()) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace

Files plugin_files(XmlRpc::XmlRpcValue value) {
  const wend::Unexpected<std::string> wrong(
      "~plugins: a list or a text of shared objects expected");
  if (value.getType() == XmlRpc::XmlRpcValue::TypeString) {
    return files_in(static_cast<std::string>(value));
  }
  if (value.getType() != XmlRpc::XmlRpcValue::TypeArray) return wrong;
  std::vector<std::string> files;
  for (int i = 0; i < value.size(); ++i) {
    if (value[i].getType() != XmlRpc::XmlRpcValue::TypeString) return wrong;
    files.push_back(static_cast<std::string>(value[i]));
  }
  return files;
}

std::string load_plugins(const ros::NodeHandle& own) {
  XmlRpc::XmlRpcValue value;
  if (!own.getParam("plugins", value)) return {};
  const Files files = plugin_files(value);
  if (!files) return files.error();
  for (const std::string& file : *files) {
    const auto names = wend::load_planners(file);
    if (!names) return "~plugins: " + names.error().message;
    for (const std::string& name : *names) ROS_INFO_STREAM(file << ": planner '" << name << "'");
  }
  return {};
}

}  // namespace wend_ros
