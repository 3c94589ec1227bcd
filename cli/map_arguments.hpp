#pragma once

// The map file, as convert takes it too, and the robot on the map, as plan, field, info and bench do.

#include <optional>
#include <string>

#include "coordinates.hpp"
#include "parser.hpp"
#include "wend/io/loaded_map.hpp"
#include "wend/map/free_space.hpp"

namespace wend::cli {

struct MapFileArguments {
  std::string file;
  std::optional<double> resolution;

  /// `name` is what help calls the file.
  void add_to(Parser& app, const std::string& name);

  /// Throws InputError if the map cannot be read.
  LoadedMap load() const;
};

/// The robot that is to be on a map.
struct RobotArguments {
  double robot_radius = 0;  // in the user's units
  UnknownPolicy unknown = UnknownPolicy::blocked;
  std::optional<OutsidePolicy> outside;
  std::optional<double> keep_away;  // in the user's units
  std::optional<double> keep_away_cost;
  bool cells = false;

  void add_to(Parser& app);

  /// --keep-away and --keep-away-cost, for commands to which it matters what a cell costs.
  void add_keep_away_to(Parser& app);

  Coordinates coordinates(const GridMap& map) const { return {map, cells}; }
  /// Throws InputError for a --keep-away-cost that costs nothing.
  FreeSpaceOptions options(const GridMap& map) const;
  FreeSpace free_space(const GridMap& map) const { return FreeSpace(map, options(map)); }
};

struct MapArguments : MapFileArguments, RobotArguments {
  void add_to(Parser& app);
};

}  // namespace wend::cli
