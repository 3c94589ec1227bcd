#pragma once

// FreeSpace: a map for one robot. From the map, the robot's radius and the policies for unknown
// cells and for the outside of the map it computes passable cells, exact clearance, connected
// components, and the reason why a cell is blocked.
//
// The robot is a disc of radius r that stands on cell centres. It may stand where its centre is at
// least r away from every closed blocked square (touching is allowed; r = 0 is a point). Its centre
// stays on the map. OutsidePolicy says whether its disc may leave the map; if not, the map's edge
// counts in clearance like an obstacle.
//
// A clearance cost makes cells near obstacles cost more, smoothly, up to a distance. Paths then
// keep their distance where there is room, and still use narrow passages. With d = clearance - r,
// the free width at the disc's edge, a passable cell's terrain is the map's times
//
//   1 + clearance_cost * (1 - d / clearance_distance)^2  where d < clearance_distance, else 1
//
// It is at least the map's, so no admissible heuristic becomes inadmissible, and it reaches the
// map's with slope 0. Clearance is that of the cell's centre.
//
// Immutable and cheap to copy: copies share everything, also between threads. Made in O(cells); 9
// bytes a cell, and eight more where the clearance cost makes any cell cost more.
//
//   const wend::FreeSpace space(map, {.robot_radius = 0.2});
//   if (const auto reason = space.why_blocked({3, 4})) ...

#include <cassert>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "wend/map/bit_grid.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/map/grid.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// Whether unknown cells are obstacles.
enum class UnknownPolicy { blocked, free };

/// Whether the robot's disc may leave the map. Its centre never does.
enum class OutsidePolicy { blocked, free };

/// The default policy: a map in metres (Frame::metric) shows a part of the world (free), a map in
/// cells all of it (blocked).
OutsidePolicy default_outside_policy(const Frame& frame);

struct FreeSpaceOptions {
  double robot_radius = 0;  // metres (cells, where the map's resolution is 1), finite, >= 0
  UnknownPolicy unknown = UnknownPolicy::blocked;
  std::optional<OutsidePolicy> outside = {};  // nothing: default_outside_policy()
  double clearance_distance = 0;  // from the disc's edge, units as robot_radius, finite; 0 = off
  double clearance_cost = 4;      // how much more a cell costs where the disc touches, finite, >= 0

  friend bool operator==(const FreeSpaceOptions&, const FreeSpaceOptions&) = default;
};

enum class BlockReason {
  outside,    // not a cell of the map
  obstacle,   // occupied
  unknown,    // unknown, and unknown cells are blocked
  too_close,  // free, but nearer to a blocked cell than the robot's radius
  over_edge,  // the same of the map's edge, which is nearer than any blocked cell
};

/// "outside the map", "an obstacle", "unknown", "closer to an obstacle than the robot's radius", "so
/// close to the map's edge that the robot would leave the map".
std::string_view describe(BlockReason reason);

/// The memory of a FreeSpace without its map.
double free_space_bytes_per_cell(const GridMap& map, const FreeSpaceOptions& options);

class FreeSpace {
 public:
  explicit FreeSpace(GridMap map, FreeSpaceOptions options = {});

  const GridMap& map() const { return data_->map; }

  /// As given, but `outside` is set.
  const FreeSpaceOptions& options() const { return data_->options; }
  OutsidePolicy outside() const {
    assert(data_->options.outside);
    return *data_->options.outside;
  }
  int width() const { return data_->passable.width(); }
  int height() const { return data_->passable.height(); }
  bool contains(Cell cell) const { return data_->passable.contains(cell); }

  /// May the robot's centre be in the middle of this cell? False outside the map.
  bool passable(Cell cell) const { return contains(cell) && data_->passable[cell]; }
  const BitGrid& passable() const { return data_->passable; }

  /// The cells that are obstacles to this robot: occupied, and unknown if those are blocked.
  const BitGrid& obstacles() const { return data_->obstacles; }

  /// Why the robot may not stand there; nothing if it may.
  std::optional<BlockReason> why_blocked(Cell cell) const;

  /// From the cell's centre to the nearest obstacle square, or to the map's edge if the outside is
  /// blocked, in cells; infinite where there is neither (or none within 32768 cells).
  double clearance(Cell cell) const;

  /// The same for all cells, squared and in half-cells, exact (see distance_field.hpp).
  const Grid<std::uint32_t>& squared_half_cell_clearance() const { return data_->clearance; }

  /// The robot's radius in cells.
  double radius_in_cells() const {
    return data_->options.robot_radius / data_->map.frame().resolution;
  }

  /// Is an obstacle at this squared distance (in half-cells) far enough? At 0 it never is. Radii
  /// that are whole half-cells up to rounding are taken as such, so that 0.3 m at 0.1 m a cell are 3
  /// cells.
  bool far_enough(double squared_half_cells) const {
    return squared_half_cells >= data_->least_squared_half_cells;
  }

  /// The cost of a unit of length in a cell, at least 1: the map's terrain, and more near obstacles
  /// if there is a clearance cost.
  double terrain(Cell cell) const { return uniform_terrain() ? 1 : terrain()[cell]; }
  bool uniform_terrain() const { return terrain().empty(); }

  /// The multipliers, or an empty grid on uniform terrain. The map's own grid if the clearance cost
  /// is off or changes no passable cell.
  const Grid<double>& terrain() const {
    return data_->terrain.empty() ? data_->map.terrain() : data_->terrain;
  }

  const ConnectedComponents& components() const { return data_->components; }

 private:
  struct Data {
    GridMap map;
    FreeSpaceOptions options;
    double least_squared_half_cells;
    BitGrid obstacles;
    Grid<std::uint32_t> clearance;
    BitGrid passable;
    ConnectedComponents components;
    Grid<double> terrain;  // empty if it is the map's
  };

  std::shared_ptr<const Data> data_;
};

}  // namespace wend
