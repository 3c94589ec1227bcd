#pragma once

// The map file, as convert takes it too, and the robot on the map, as plan, field and info do.

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

struct MapArguments : MapFileArguments {
  double robot_radius = 0;  // in the user's units
  UnknownPolicy unknown = UnknownPolicy::blocked;
  double keep_away = 0;  // in the user's units
  double keep_away_cost = FreeSpaceOptions{}.keep_away_cost;
  bool cells = false;

  void add_to(Parser& app);

  Coordinates coordinates(const GridMap& map) const { return {map, cells}; }
  FreeSpace free_space(const GridMap& map) const;
};

}  // namespace wend::cli
