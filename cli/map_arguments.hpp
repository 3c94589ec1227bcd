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
  double keep_away = 0;  // in the user's units
  double keep_away_cost = FreeSpaceOptions{}.keep_away_cost;
  bool cells = false;

  void add_to(Parser& app);

  Coordinates coordinates(const GridMap& map) const { return {map, cells}; }
  FreeSpaceOptions options(const GridMap& map) const;
  FreeSpace free_space(const GridMap& map) const { return FreeSpace(map, options(map)); }
};

struct MapArguments : MapFileArguments, RobotArguments {
  void add_to(Parser& app);
};

}  // namespace wend::cli
