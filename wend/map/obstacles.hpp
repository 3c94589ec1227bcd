#pragma once

// Obstacles: what is blocked on a map for every robot (occupied cells, unknown cells and the outside of
// the map if the policies block them), and the exact distance from each cell to it.
//
// Cheap to copy: copies share everything, also between threads; an edit changes one copy only. So the free spaces
// of several robots on a map share one distance field. Built in O(cells / 64); takes 1 bit for each cell, and
// 4 bytes more once somebody asks for the distances of all cells.
//
//   const wend::Obstacles obstacles(map, {.unknown = wend::UnknownPolicy::free});
//   const auto small = wend::make_free_space(obstacles, {.footprint = wend::Footprint::disc(0.2)});
//   const auto large = wend::make_free_space(obstacles, {.footprint = wend::Footprint::disc(0.5)});

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/copy_on_write.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/error.hpp"
#include "wend/base/lazy.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// Whether unknown cells are obstacles.
enum class UnknownPolicy {
  blocked,  // they are obstacles
  free      // they are free
};

/// Whether the robot's shape may leave the map. Its base point never does.
enum class OutsidePolicy {
  blocked,  // the map's edge is an obstacle
  free      // the shape may hang over the map's edge
};

/// The default policy: blocked for a map in metres (Frame::metric), which shows a part of the world;
/// free for a map in cells, which shows all of its world.
WEND_API OutsidePolicy default_outside_policy(const Frame& frame);

/// The policies for cells that a map does not describe.
struct ObstacleOptions {
  UnknownPolicy unknown = UnknownPolicy::blocked;  // unknown cells
  std::optional<OutsidePolicy> outside = {};       // nothing: default_outside_policy()

  friend bool operator==(const ObstacleOptions&, const ObstacleOptions&) = default;
};

class WEND_API Obstacles {
 public:
  /// The obstacles of a map. O(cells / 64).
  explicit Obstacles(GridMap map, ObstacleOptions options = {});

  /// The map that they were made from.
  const GridMap& map() const { return data_->map; }
  /// The policy for unknown cells.
  UnknownPolicy unknown() const { return data_->unknown; }
  /// The policy for the outside, as set or by default.
  OutsidePolicy outside() const { return data_->outside; }

  /// The blocked cells.
  const BitGrid& blocked() const { return data_->blocked; }

  /// The distance from a cell's centre to the nearest blocked square, or to the map's edge if the
  /// outside is blocked, in cells; infinite if there is neither (or none within 32768 cells). Looks for
  /// it: O(its square / 64). The distances of all cells are made, and looked up from then on, once the
  /// questions have read more than that costs.
  double clearance(Cell cell) const;

  /// The same squared and in half-cells, exact (see distance_field.hpp), but at most `most`: it does not
  /// look farther.
  std::uint32_t squared_half_cell_clearance(Cell cell, std::uint32_t most) const;

  /// The same for all cells. Made when it is first asked for, in O(cells), once for all threads; takes 4 bytes
  /// for each cell.
  const Grid<std::uint32_t>& squared_half_cell_clearance() const;
  /// Makes them now, if nobody has. False if the deadline passed before.
  bool make_clearance(DeadlineCheck& stop) const;

  /// Changes cells of the map; other copies keep what they were. Fails as GridMap::edit() does. Returns boxes
  /// that contain the cells that are blocked otherwise than before, or may cost otherwise: none where an unknown
  /// cell turns out to be what it was taken for. O(cells of the edit); distances of all cells are forgotten.
  Expected<std::vector<CellBox>, Error> edit(const MapEdit& edit);

  /// Is the map's edge at least as near to the centre of a cell as every blocked square?
  bool edge_is_nearest(Cell cell) const;

 private:
  Grid<std::uint32_t> clearance_of_all(DeadlineCheck& stop) const;

  struct Data {
    GridMap map;
    UnknownPolicy unknown;
    OutsidePolicy outside;
    BitGrid blocked;
    Lazy<Grid<std::uint32_t>> clearance = {};
    mutable std::atomic<std::size_t> words_read = 0;  // to find clearances of single cells

    Data(GridMap its_map, const ObstacleOptions& options);
    Data(const Data& other);  // with the distances if they have been made
    Data& operator=(const Data&) = delete;
    ~Data() = default;
  };

  CopyOnWrite<Data> data_;
};

}  // namespace wend
