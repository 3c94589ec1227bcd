#pragma once

// The map and the robot on it, as plan, field and info take them.

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "coordinates.hpp"
#include "wend/io/loaded_map.hpp"
#include "wend/map/free_space.hpp"

namespace wend::cli {

struct MapArguments {
  std::string file;
  std::optional<double> resolution;
  double robot_radius = 0;  // in the user's units
  UnknownPolicy unknown = UnknownPolicy::blocked;
  bool cells = false;

  void add_to(CLI::App& app);

  /// Throws InputError if the map cannot be read.
  LoadedMap load() const;

  Coordinates coordinates(const GridMap& map) const { return {map, cells}; }
  FreeSpace free_space(const GridMap& map) const;
};

}  // namespace wend::cli
