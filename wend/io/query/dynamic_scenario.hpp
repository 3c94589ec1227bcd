#pragma once

// Dynamic scenarios, `.scen` files of version 2: queries on a map that changes between them, as the grid-based path
// planning competition has them.
//
//   version 2
//   height 209
//   width 281
//   cost 1 octile
//   patch dao_arena2.patch
//   commands
//   Q 0 6 144 277 165 279.69848480984      bucket, start x y, goal x y, length of a shortest path
//   P 1 0 81 162                           bucket, patch, x y of its upper left cell
//
// The map is free at first. A patch overwrites its cells: '.', 'G' and 'S' are free, all else is blocked. The patch
// file lies in the scenario's folder:
//
//   type patch
//   patches 336
//   patch 0
//   height 12
//   width 10
//   map
//   @@@@@@@@@.                             height rows of width letters
//
// Cells and lengths are as in other scenarios (scenario.hpp).

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/query/scenario.hpp"
#include "wend/map/grid.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/map_edit.hpp"

namespace wend {

/// Puts a patch on the map.
struct PatchCommand {
  std::size_t patch;  // its number
  Cell corner;        // that its first cell overwrites
};

/// The content of a dynamic scenario.
struct DynamicScenario {
  /// A change of the map, or a query on it as it is then.
  using Command = std::variant<PatchCommand, ScenarioQuery>;

  std::string file;                      // its name
  std::filesystem::path patch_file;      // as it names it
  int width = 0;                         // cells
  int height = 0;                        // cells
  std::vector<Grid<CellState>> patches;  // by number
  std::vector<Command> commands;         // in the order of the file

  /// The edit of a command of this scenario.
  MapEdit edit_of(const PatchCommand& command) const {
    return {.corner = command.corner, .states = patches[command.patch]};
  }
};

/// The most cells of a map of a dynamic scenario, which has no other bound.
inline constexpr std::size_t kMostDynamicCells = std::size_t{1} << 28U;

/// Is the text that of a dynamic scenario? Its first line says so.
WEND_API bool is_dynamic_scenario(std::string_view text);

/// Reads both files. All cells lie on the map, lengths are finite and at least 0.
WEND_API Expected<DynamicScenario, Error> load_dynamic_scenario(const std::filesystem::path& file);

/// The same from texts. `file` is the name for errors; `read_patches` reads the patch file of this name, which is
/// not a path.
WEND_API Expected<DynamicScenario, Error> parse_dynamic_scenario(
    std::string_view text, const std::string& file,
    const std::function<Expected<std::string, Error>(const std::filesystem::path&)>& read_patches);

}  // namespace wend
