#include "wend/plugin/load_planners.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "wend/io/files.hpp"
#include "wend/planner/planners.hpp"
#include "wend/plugin/planner_plugin.hpp"
#include "wend/version.hpp"

namespace wend {
namespace {

constexpr std::size_t kLargestPlugin = std::size_t{1} << 30;  // bytes

Error invalid_plugin(const std::filesystem::path& plugin, const std::string& why) {
  return {Status::invalid_file, plugin.string() + ": " + why, plugin.string()};
}

template <class Function>
Function function_named(void* library, const char* name) {
  // POSIX: dlsym() returns functions as void*.
  return reinterpret_cast<Function>(dlsym(library, name));
}

/// The version in the file of a plugin. Running its code to ask for it could already fail.
std::optional<std::string> version_in(std::string_view bytes) {
  constexpr std::string_view kMark = WEND_PLUGIN_VERSION_MARK;
  for (auto at = bytes.find(kMark); at != std::string_view::npos; at = bytes.find(kMark, at + 1)) {
    const std::string_view behind = bytes.substr(at + kMark.size());
    const auto end = std::min(behind.find_first_not_of("0123456789."), behind.size());
    if (end > 0) return std::string(behind.substr(0, end));
  }
  return std::nullopt;
}

/// Why a file is not a plugin for this program, as far as one can tell without running it.
std::optional<Error> unfit(const std::filesystem::path& plugin) {
  const auto bytes = read_file(plugin, kLargestPlugin);
  if (!bytes) return bytes.error();
  const auto version = version_in(*bytes);
  if (!version)
    return invalid_plugin(plugin, "not a plugin of wend: it lacks WEND_PLANNER_PLUGIN()");
  if (*version == WEND_VERSION) return std::nullopt;
  return invalid_plugin(plugin, "compiled for wend " + *version +
                                    ", but this is wend " WEND_VERSION ": compile it again");
}

}  // namespace

const void* library_mark() {
  static const char mark = 0;
  return &mark;
}

Expected<std::vector<std::string>, Error> load_planners(const std::filesystem::path& plugin) {
  if (auto error = unfit(plugin)) return Unexpected<Error>(*std::move(error));
  // A name without a folder would be looked up among the libraries of the system. Never closed: the
  // registry holds its functions.
  void* const library = dlopen(std::filesystem::absolute(plugin).c_str(), RTLD_NOW | RTLD_LOCAL);
  const auto refused = [&](const std::string& why) {
    return Unexpected<Error>(invalid_plugin(plugin, why));
  };
  if (library == nullptr) return refused(std::string("cannot load it: ") + dlerror());
  using Mark = const void* (*)();
  using Planners = void (*)(std::vector<PlannerInfo>*);
  const auto mark = function_named<Mark>(library, "wend_plugin_library");
  const auto planners_of = function_named<Planners>(library, "wend_plugin_planners");
  if (mark == nullptr || planners_of == nullptr) {
    return refused("not a plugin of wend: it lacks WEND_PLANNER_PLUGIN()");
  }
  if (mark() != library_mark()) {
    return refused(
        "it uses another copy of libwend than this program, which must be linked with the shared "
        "library (BUILD_SHARED_LIBS)");
  }
  std::vector<PlannerInfo> made;
  planners_of(&made);
  std::vector<std::string> names;
  names.reserve(made.size());
  for (const PlannerInfo& planner : made) names.push_back(planner.name);
  if (auto added = add_planners(std::move(made)); !added) {
    return refused(added.error().message);
  }
  return names;
}

}  // namespace wend
