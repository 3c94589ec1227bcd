#pragma once

// FreeSpace: where one robot may be on a map. Obstacles + footprint give passable cells, connected
// components, the reason why a cell or a pose is blocked, and the cost of a unit of length.
//
// A disc of radius r may stand where its centre is at least r away from every closed blocked square
// (touching is allowed; r = 0 is a point, which must stay out of their interior). A polygon may stand
// where it overlaps the interior of no blocked square; its base point may lie outside it, and then also
// above an obstacle or an unknown cell. The base point stays on the map. OutsidePolicy says whether the
// shape may hang over the map's edge; if not, the edge counts in clearance like an obstacle's.
//
// Grid planners do not know headings. They use the circumscribed disc of a polygon, the one around its
// base point, with which it fits at every heading: this never misses an obstacle, but may miss a narrow
// passage.
//
// A clearance cost makes cells near obstacles cost more, smoothly, up to a distance. Paths then keep
// their distance where there is room, and still use narrow passages. With d = clearance - r, the free
// width at the edge of the (circumscribed) disc, a passable cell's terrain is the map's times
//
//   1 + clearance_cost * (1 - d / clearance_distance)^2  where d < clearance_distance, else 1
//
// rounded to 1/256 (see CostMap). The result is at least 1, so admissible heuristics stay admissible, and
// it reaches the map's with slope 0. Clearance is that of the cell's centre.
//
// Cheap to copy: copies share everything, also between threads; free spaces of several robots share the
// Obstacles that they are made of. An edit changes one copy only. Built in O(cells), for a point in
// O(cells / 64); takes half a byte for each cell, up to 6 more for each run of passable cells in a row, two
// bytes for a robot with a radius or a clearance cost, and two more if any cell costs more than 1.
//
//   const auto robot = wend::parse_footprint("0.4,0.25; 0.4,-0.25; -0.3,-0.25; -0.3,0.25");
//   const auto space = wend::make_free_space(map, {.footprint = *robot});
//   if (const auto reason = space->why_blocked(wend::Cell{3, 4})) ...

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/copy_on_write.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/error.hpp"
#include "wend/base/lazy.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/capped_distances.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/map/cost_map.hpp"
#include "wend/map/distance_field.hpp"
#include "wend/map/grid.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/obstacles.hpp"
#include "wend/robot/disc_ring.hpp"
#include "wend/robot/footprint.hpp"
#include "wend/robot/motion_primitives.hpp"
#include "wend/robot/space_attachments.hpp"
#include "wend/robot/space_change.hpp"

namespace wend {

class CellCosts;

/// A robot as planners see it. Lengths are in metres (cells if the map's resolution is 1).
struct Robot {
  Footprint footprint = {};       // its shape
  double clearance_distance = 0;  // from the disc's edge, finite; 0 = off
  double clearance_cost = 4;      // extra cost of a cell where the disc touches, finite, >= 0
  std::optional<MotionPrimitives> primitives = {};  // nothing: the planner chooses

  friend bool operator==(const Robot&, const Robot&) = default;
};

/// A robot, and what blocks it.
struct FreeSpaceOptions {
  Footprint footprint = {};                         // the robot's shape, in metres
  UnknownPolicy unknown = UnknownPolicy::blocked;   // whether unknown cells are obstacles
  std::optional<OutsidePolicy> outside = {};        // nothing: default_outside_policy()
  double clearance_distance = 0;                    // as in Robot
  double clearance_cost = 4;                        // as in Robot
  std::optional<MotionPrimitives> primitives = {};  // as in Robot

  /// The options that describe the robot.
  Robot robot() const { return {footprint, clearance_distance, clearance_cost, primitives}; }
  /// The options that decide what blocks it.
  ObstacleOptions obstacles() const { return {unknown, outside}; }

  friend bool operator==(const FreeSpaceOptions&, const FreeSpaceOptions&) = default;
};

/// Why a robot cannot stand somewhere.
enum class BlockReason {
  outside,    // not on the map
  obstacle,   // occupied
  unknown,    // unknown, and unknown cells are blocked
  too_close,  // free, but nearer to a blocked cell than the radius of the (circumscribed) disc
  over_edge,  // the same for the map's edge, which is nearer than any blocked cell
  overlaps,   // at this pose the robot's polygon overlaps a blocked cell
  leaves,     // at this pose the robot's polygon reaches over the map's edge
};

/// "outside the map", "an obstacle", "unknown", "closer to an obstacle than the robot's radius", ...
WEND_API std::string_view describe(BlockReason reason);

/// The memory of a FreeSpace without its map, in bytes per cell.
WEND_API double free_space_bytes_per_cell(const GridMap& map, const FreeSpaceOptions& options);

class WEND_API FreeSpace {
 public:
  /// The map that the space was made from.
  const GridMap& map() const { return data_->obstacles.map(); }
  /// What blocks the robot; other free spaces may share it.
  const Obstacles& obstacles() const { return data_->obstacles; }
  /// The robot that the space was made for.
  const Robot& robot() const { return data_->robot; }
  /// The shape of the robot, in metres.
  const Footprint& footprint() const { return data_->robot.footprint; }

  /// The options that make the same space from the same map; `outside` is set.
  FreeSpaceOptions options() const;

  /// Whether the robot's shape may leave the map.
  OutsidePolicy outside() const { return data_->obstacles.outside(); }
  /// The number of columns of the map.
  int width() const { return data_->passable.width(); }
  /// The number of rows of the map.
  int height() const { return data_->passable.height(); }
  /// Is the cell on the map?
  bool contains(Cell cell) const { return data_->passable.contains(cell); }

  /// May the robot's base point be in the middle of this cell, whatever its heading? False outside
  /// the map.
  bool passable(Cell cell) const { return contains(cell) && data_->passable[cell]; }
  /// The cells in whose middle the robot may stand at every heading.
  const BitGrid& passable() const { return data_->passable; }

  /// The cells in whose middle the robot may be able to stand at some heading: its inner disc fits there
  /// at one. They include the passable cells; for a point or a disc the two sets are equal. Where the base
  /// point lies outside a polygon, blocked cells may be among them.
  const BitGrid& possible() const {
    return data_->possible.width() == 0 ? data_->passable : data_->possible;
  }

  /// The cells in which the centre of the robot's inner disc (Footprint::inner_disc()) can be somewhere.
  /// Empty unless the base point lies outside a polygon.
  const BitGrid& inner_disc_cells() const { return data_->inner_disc_cells; }

  /// May the robot stand at this pose, in grid coordinates? Exact up to rounding. O(1) if the clearance
  /// of a cell decides, else O(cells that the robot covers, times its corners).
  bool fits(const Pose& pose) const { return !why_blocked(pose); }

  /// Why the robot may not stand at every heading in the middle of a cell; nothing if it may.
  std::optional<BlockReason> why_blocked(Cell cell) const;
  /// Why the robot may not stand at a pose in grid coordinates; nothing if it may. A pose that
  /// contains NaN or infinity is outside.
  std::optional<BlockReason> why_blocked(const Pose& pose) const;

  /// The same as Obstacles::clearance().
  double clearance(Cell cell) const {
    return distance_in_cells(squared_half_cell_clearance(cell, kNoObstacle));
  }
  /// The same if it is less than `most` cells, else at least `most`: it does not look farther. O(1) near
  /// obstacles, as far as the robot needs distances.
  double clearance(Cell cell, double most) const;
  /// The squared clearance of a cell in half-cells, at most `most`: as Obstacles does, and O(1) near
  /// obstacles.
  std::uint32_t squared_half_cell_clearance(Cell cell, std::uint32_t most) const {
    const CappedDistances& near = data_->distances;
    if (!near.empty()) {
      const std::uint32_t squared = near[cell];
      if (squared < near.far() || most <= near.far()) return std::min(squared, most);
    }
    return data_->obstacles.squared_half_cell_clearance(cell, most);
  }
  /// Do the distances that the robot needs show that the squared clearance of a cell is at least this, in
  /// half-cells? If not, it may be nevertheless. O(1).
  bool is_known_clear(Cell cell, std::uint32_t squared_half_cells) const {
    const CappedDistances& near = data_->distances;
    return !near.empty() && near[cell] >= squared_half_cells;
  }
  /// The cells that are not blocked and whose squared clearance, in half-cells, is at least `least`: at most that from
  /// which on it is far_enough(). O(cells / 8) if the robot needs distances.
  BitGrid cells_clear_by(double least) const;
  /// The same as Obstacles::squared_half_cell_clearance() of all cells.
  const Grid<std::uint32_t>& squared_half_cell_clearance() const {
    return data_->obstacles.squared_half_cell_clearance();
  }

  /// The robot's radius in cells; for a polygon that of its circumscribed disc.
  double radius_in_cells() const {
    return footprint().circumscribed_radius() / map().frame().resolution;
  }
  /// The radius of the inscribed disc (Footprint::inscribed_radius()) in cells.
  double inscribed_radius_in_cells() const {
    return footprint().inscribed_radius() / map().frame().resolution;
  }
  /// Is the robot a point?
  bool is_point() const { return footprint().is_point(); }

  /// The robot's polygon in cells; null for a point or a disc.
  const Polygon* outline() const { return data_->outline ? &*data_->outline : nullptr; }

  /// Is an obstacle at this squared distance (in half-cells) from the base point far enough for every
  /// heading? At 0 it never is. Radii that are whole half-cells up to rounding are rounded to them, so
  /// that 0.3 m at 0.1 m a cell are 3 cells.
  bool far_enough(double squared_half_cells) const {
    return squared_half_cells >= data_->least_squared_half_cells;
  }

  /// The cost of a unit of length in a cell, at least 1: the map's terrain, and more near obstacles
  /// if there is a clearance cost, rounded to 1/256. All planners and path costs use it.
  double terrain(Cell cell) const { return data_->costs.multiplier(cell); }
  /// Does a unit of length cost 1 in every cell?
  bool uniform_terrain() const { return data_->costs.uniform(); }
  /// The multipliers of all cells as integers.
  const CostMap& costs() const { return data_->costs; }

  /// The connected components of the passable cells. Made when they are first asked for, in O(cells / 64
  /// + runs), once for all threads.
  const ConnectedComponents& components() const {
    return data_->components.get([this] { return ConnectedComponents(passable()); });
  }
  /// Have they been made?
  bool knows_components() const { return data_->components.made(); }
  /// Makes them now, and prepares them for questions with this adjacency. False if the deadline passed before.
  bool make_components(Adjacency adjacency, const Deadline& deadline) const;

  /// What planners have prepared for this space, a SpaceAttachment of type T: make() makes it when somebody first
  /// asks for it, as a std::shared_ptr, and copies of the space share it, also between threads. An edit in place
  /// tells it what has changed; if somebody else holds it then, or the edit copies the space, the edited space
  /// begins without it.
  template <class T, class Make>
  std::shared_ptr<T> attachment(Make&& make) const {
    return data_->attachments.template get<T>(std::forward<Make>(make));
  }

  /// Changes cells of the map, and what follows from them as far as they reach; other copies keep what
  /// they were. The result is the same as if the space were made of the edited map. Fails as
  /// GridMap::edit() and make_free_space() do, and changes nothing then.
  ///
  /// O(cells of the edit and around it, as far as the robot needs distances) if no other copy, nor another
  /// copy of the Obstacles or the map, shares the data; else what is shared is copied first, in O(cells).
  /// The space is made anew, in O(cells), if the robot needs distances of more than 63 cells, or if a
  /// cell costs 256 times its length or more. Then it fails with time_limit or cancelled if the deadline passes before;
  /// with a deadline, edits of so many cells that a repair takes long make it anew, too.
  Expected<SpaceChange, Error> edit(const MapEdit& edit, const Deadline& deadline = {});

 private:
  friend Expected<FreeSpace, Error> make_free_space(Obstacles, Robot, const Deadline&);

  FreeSpace(Obstacles obstacles, Robot robot, DeadlineCheck& stop)
      : data_(std::in_place, std::move(obstacles), std::move(robot), stop) {}

  BlockReason reason_in(Cell blocked) const;
  bool can_repair(const MapEdit& edit) const;
  Expected<SpaceChange, Error> make_edited(const MapEdit& edit, const Deadline& deadline);

  struct Data {
    Obstacles obstacles;
    Robot robot;
    std::optional<Polygon> outline;  // in cells
    double least_squared_half_cells;
    std::shared_ptr<const CellCosts> cell_costs;  // of the robot
    CappedDistances distances;  // as far as the robot needs them; empty if it needs none, or more
    BitGrid passable;
    BitGrid possible;              // empty if it is the same
    std::optional<DiscRing> ring;  // where the base point lies outside a polygon
    BitGrid inner_disc_cells = {};
    CostMap costs;
    Lazy<ConnectedComponents> components = {};
    SpaceAttachments attachments = {};

    Data(Obstacles its_obstacles, Robot its_robot, DeadlineCheck& stop);
    /// Computes what follows from a box of cells in which the map has changed. Returns the box in which
    /// anything may have changed.
    CellBox repair(const CellBox& edited);

   private:
    void select_possible(const CellBox& box, DeadlineCheck& stop = DeadlineCheck::never());
  };

  CopyOnWrite<Data> data_;
};

/// Makes the free space of a robot. Fails with invalid_option if the radius of the footprint, or one of
/// the clearance options, is NaN or out of range, and with unsupported_map if a cell costs more than
/// CostMap::kLargest; Error::where names the part.
WEND_API Expected<FreeSpace, Error> make_free_space(GridMap map,
                                                    const FreeSpaceOptions& options = {});

/// The same on shared obstacles. Fails with time_limit or cancelled if the deadline passes before the space is ready.
WEND_API Expected<FreeSpace, Error> make_free_space(Obstacles obstacles, Robot robot,
                                                    const Deadline& deadline = {});

/// The cell of the map that contains a point in grid coordinates, if any; nothing for NaN.
WEND_API std::optional<Cell> cell_under(const FreeSpace& space, Point point);

}  // namespace wend
