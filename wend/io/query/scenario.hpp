#pragma once

// MovingAI `.scen` files: queries on a map, with the length of a shortest path for each.
//
//   version 1
//   0  maps/dao/arena.map  49  49  1  11  1  12  1
//
// A line holds bucket, map, the map's width and height, start x y, goal x y and the optimal length,
// separated by tabs (blanks in some sets). Cells count from the upper-left one, x first. Lengths are for
// 8 neighbours without corner cutting and are printed with 2 or 8 decimals or 6 significant digits.
//
// The map column is a label with a stale folder: scenario_map_path() says which file is meant.

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/io/file_error.hpp"

namespace wend {

/// One line of a scenario.
struct ScenarioQuery {
  std::size_t line;  // in the file, from 1
  int bucket;        // a label: about a quarter of the length
  std::string map;   // the map column as written
  int map_width;     // cells, as the line says
  int map_height;    // cells, as the line says
  Cell start;        // where the path begins
  Cell goal;         // where the path ends
  double length;     // of a shortest path
  int decimals;      // of the length in the file

  /// There is no path if the length is 0 between different cells, as files write it, or infinite.
  bool says_no_path() const { return std::isinf(length) || (length == 0 && start != goal); }
};

/// The content of a `.scen` file.
struct Scenario {
  std::string file;                    // its name
  std::vector<ScenarioQuery> queries;  // in the order of the file
};

/// The number of decimals of a number as it is written: 2 of "1.50".
WEND_API int decimals_of(std::string_view number);

/// Start and goal lie inside the map size that their line gives; lengths are finite and >= 0.
WEND_API Expected<Scenario, Error> load_scenario(const std::filesystem::path& file);

/// The same from a text. `file` is the name for errors.
WEND_API Expected<Scenario, Error> parse_scenario(std::string_view text, const std::string& file);

/// The text of a file with these queries; `decimals` is the number of decimals of a length.
WEND_API std::string format_scenario(const std::vector<ScenarioQuery>& queries);

/// The `.scen` files directly in a folder, sorted by name. An error if the folder has no such file.
WEND_API Expected<std::vector<std::filesystem::path>, Error> scenarios_in(
    const std::filesystem::path& folder);

/// Fails, with the line, if a query is for a map of another size. (The format says to scale the map
/// then; no set that we know needs it, so this is an error.)
WEND_API Expected<void, Error> check_map_size(const Scenario& scenario, int width, int height);

/// The map of a scenario. `X.map.scen` means `X.map` if that file exists, and `X.yaml.scen` means
/// `X.yaml`; else it is the last part of the map column. In both cases it must be a file in the
/// scenario's own folder, else it is an error.
WEND_API Expected<std::filesystem::path, Error> scenario_map_path(const Scenario& scenario);

/// At most `count` of the queries, evenly spread and in their order.
WEND_API std::vector<ScenarioQuery> evenly_sampled(const std::vector<ScenarioQuery>& queries,
                                                   std::size_t count);

/// Whether the length `found` matches the query: it may differ by 1e-5 of the length or, if the file
/// prints 2 or 8 decimals, by half a unit of the last one.
WEND_API bool length_matches(const ScenarioQuery& query, double found);

}  // namespace wend
