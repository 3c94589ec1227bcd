#include "cli/arguments/plugins.hpp"

#include <iterator>
#include <string_view>

#include "wend/plugin/load_planners.hpp"

namespace wend::cli {
namespace {

constexpr std::string_view kPluginFlag = "--plugin";

}  // namespace

std::string load_plugins(std::vector<std::string>& arguments, std::vector<std::string>& files) {
  constexpr const char* kNoFile = "--plugin: the name of a shared object is missing";
  const std::string with_value = std::string(kPluginFlag) + "=";
  std::vector<std::string> others;
  for (auto word = arguments.begin(); word != arguments.end(); ++word) {
    if (*word == "--") {
      others.insert(others.end(), word, arguments.end());
      break;
    }
    const bool joined = word->starts_with(with_value);
    if (!joined && *word != kPluginFlag) {
      others.push_back(*word);
      continue;
    }
    if (!joined && std::next(word) == arguments.end()) return kNoFile;
    const std::string file = joined ? word->substr(with_value.size()) : *++word;
    if (file.empty()) return kNoFile;
    const auto loaded = load_planners(file);
    if (!loaded) return "--plugin " + loaded.error().message;
    files.push_back(file);
  }
  arguments = std::move(others);
  return {};
}

void add_plugin_option(Parser& app) {
  const auto nothing = [](const std::string& /*file*/) {};  // load_plugins() has read it
  app.add_option(std::string(kPluginFlag), nothing, "Load planners from a shared object")
      .type_name("FILE");
}

}  // namespace wend::cli
