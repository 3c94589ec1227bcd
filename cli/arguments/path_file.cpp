#include "cli/arguments/path_file.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/flags.hpp"
#include "cli/arguments/input_files.hpp"
#include "cli/exit_code.hpp"

namespace wend::cli {
namespace {

/// What of a path does not lie on the map, if something does not.
std::optional<std::string> part_outside(const Path& path, const FreeSpace& space) {
  for (const Cell cell : path.cells()) {
    if (!space.contains(cell)) return "the cell " + cell_text(cell);
  }
  if (!path.cells().empty()) return std::nullopt;
  for (const Point point : path.points()) {
    if (point.x >= 0 && point.y >= 0 && point.x <= space.width() && point.y <= space.height()) {
      continue;
    }
    return fmt::format("the point ({:g},{:g})", point.x, point.y);
  }
  return std::nullopt;
}

}  // namespace

void add_path_file(Parser& app, std::string& file) {
  app.add_option("PATH", file,
                 wrapped("The path, as `wend plan -o` writes it (.csv, .json), or points in metres "
                         "(.csv with columns x_m and y_m); - reads it from standard input"))
      .required()
      .type_name(kFileType);
}

Path load_path_for(const FreeSpace& space, const std::string& file, PathStage stage) {
  return read_path(file, space.map().frame(), stage);
}

Path load_path_on(const FreeSpace& space, const std::string& file, PathStage stage) {
  Path path = load_path_for(space, file, stage);
  const auto outside = part_outside(path, space);
  if (!outside) return path;
  throw InputError(fmt::format("{}: {} does not lie on the map, which has {}", file, *outside,
                               size_text(space.map())));
}

}  // namespace wend::cli
