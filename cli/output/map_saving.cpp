#include "cli/output/map_saving.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "wend/io/map/save_map.hpp"

namespace wend::cli {

void add_force(Parser& app, bool& force) {
  app.add_flag("--force", force,
               wrapped("Replace the image of a new map.yaml even if another file uses it"));
}

void check_picture(const std::string& file, const std::string& name) {
  const auto picture = unrelated_picture(file);
  if (!picture) return;
  throw InputError(fmt::format(
      "{}: this would replace {}, which no {} names as its image; choose another name, or replace "
      "it with --force",
      name, picture->string(), file));
}

void check_force(const Parser& command, const std::vector<std::string>& names) {
  const auto has_picture = [](const std::string& name) { return saved_files(name).size() > 1; };
  if (std::ranges::any_of(names, has_picture)) return;
  refuse_idle(command, {"--force"}, "it applies to a map.yaml and its image only");
}

std::vector<std::string> files_of_maps(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    for (const auto& path : saved_files(name)) {
      const std::string file = path.string();
      if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
    }
  }
  return files;
}

}  // namespace wend::cli
