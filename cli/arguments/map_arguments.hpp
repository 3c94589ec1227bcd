#pragma once

// The map file argument, also of convert, and the robot arguments of plan, field, info and bench.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/field_flags.hpp"
#include "cli/arguments/parser.hpp"
#include "wend/io/map/load_mask.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

class Session;

namespace cli {

struct MapFileArguments {
  std::string file;
  std::optional<double> resolution;
  std::vector<MaskSpec> masks;

  /// `name` is what help calls the file.
  void add_to(Parser& app, const std::string& name);

  /// The map under its masks. Notes on it go to standard error. Throws InputError if the map or a mask cannot be read, or if a mask does not fit.
  LoadedMap load() const;

  /// The same without a word about the notes on the map, for a command that reports them.
  LoadedMap load_silently() const;
};

/// The robot on a map.
struct RobotArguments {
  FieldFlags<FreeSpaceOptions> fields;
  std::optional<Footprint> footprint;  // instead of that of the fields, in the user's units
  bool cells = false;
  std::string primitives;  // file of motion primitives

  void add_robot_to(Parser& app);

  /// --clearance-distance and --clearance-cost, for commands that use the costs of cells.
  void add_clearance_cost_to(Parser& app);

  /// --primitives, for commands that run planners of poses.
  void add_primitives_to(Parser& app);

  Coordinates coordinates(const GridMap& map) const { return {map, cells}; }
  /// The robot with lengths as they were typed, and without motion primitives.
  FreeSpaceOptions as_typed() const;
  /// Throws InputError for a --clearance-cost that costs nothing, and for a file of motion primitives
  /// that cannot be read.
  FreeSpaceOptions options(const GridMap& map) const;
  /// Throws InputError for an invalid robot, too.
  FreeSpace free_space(const GridMap& map) const;

 private:
  void add_footprint_to(Parser& app, const Argument& radius);
};

struct MapArguments : MapFileArguments, RobotArguments {
  std::optional<double> limit_memory;  // megabytes

  void add_to(Parser& app);

  /// load(), with the file of motion primitives among those that must not be overwritten.
  LoadedMap load_map() const;

  /// Throws NoPathError if the map needs more bytes than there are.
  void check_memory(const GridMap& map, double need) const;

  /// Throws NoPathError if the free space and planners of this size do not fit into memory.
  FreeSpace free_space(const GridMap& map, double planner_bytes_per_cell = 0) const;

  /// The same as a session that keeps so many planners, measures searches in CPU time, and explains itself in the
  /// options of the command line. Throws NoPathError too if the
  /// deadline passes before the space is made.
  std::unique_ptr<Session> session(const GridMap& map, std::size_t planners,
                                   double planner_bytes_per_cell,
                                   const Deadline& deadline = {}) const;
};

/// Throws NoPathError with the status memory_limit if more bytes are needed than `available`, where
/// that is known.
void check_memory(const std::string& file, const GridMap& map, double need,
                  std::optional<double> available);

}  // namespace cli
}  // namespace wend
