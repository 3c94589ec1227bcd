#pragma once

// GridMap: the content of a map file. Each cell is free, occupied or unknown and has a terrain
// multiplier; the frame is the grid's position and resolution in the world. FreeSpace adds a robot.
//
// Cheap to copy: copies share the cells, also between threads. An edit changes one copy only. A cell takes two
// bits, and eight more bytes if the map has terrain.
//
//   wend::Grid<wend::CellState> cells(20, 10, wend::CellState::free);
//   cells[{3, 4}] = wend::CellState::occupied;
//   const auto map = wend::make_grid_map(cells);
//   if (!map) return report(map.error().message);

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/copy_on_write.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"
#include "wend/map/map_edit.hpp"

namespace wend {

/// What a map file says about a cell.
enum class CellState : unsigned char {
  free,      // no obstacle
  occupied,  // an obstacle
  unknown    // not seen yet; UnknownPolicy decides
};

/// Cells that a mask blocks and the map itself does not: the zone of a keep-out mask. A robot inside may leave it.
struct MapZone {
  std::string name;  // of the mask, as messages say it; may be empty
  BitGrid cells;     // as large as the map

  friend bool operator==(const MapZone&, const MapZone&) = default;
};

class GridMap {
 public:
  /// The most cells a map can have; loaders reject larger ones.
  static constexpr std::size_t kMaxCells = std::size_t{1} << 30;

  /// The number of columns, at least 1.
  int width() const { return data_->occupied.width(); }
  /// The number of rows, at least 1.
  int height() const { return data_->occupied.height(); }
  /// The number of cells, at most kMaxCells.
  std::size_t size() const {
    return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
  }
  /// Is the cell on the map?
  bool contains(Cell cell) const { return data_->occupied.contains(cell); }

  /// How the grid lies in the world.
  const Frame& frame() const { return data_->frame; }

  /// The state of a cell, which must be on the map.
  CellState state(Cell cell) const {
    if (data_->occupied[cell]) return CellState::occupied;
    return data_->unknown[cell] ? CellState::unknown : CellState::free;
  }

  /// The occupied cells.
  const BitGrid& occupied() const { return data_->occupied; }
  /// The unknown cells.
  const BitGrid& unknown() const { return data_->unknown; }

  /// The cost of a unit of length in a cell, at least 1.
  double terrain(Cell cell) const { return data_->terrain.empty() ? 1 : data_->terrain[cell]; }
  /// Does a unit of length cost 1 in every cell?
  bool uniform_terrain() const { return data_->terrain.empty(); }

  /// The multipliers, or an empty grid on uniform terrain.
  const Grid<double>& terrain() const { return data_->terrain; }

  /// The zones of masks that were laid over the map, see masked(). Their cells are occupied.
  std::span<const MapZone> zones() const { return data_->zones; }
  /// The zone that blocks a cell of the map; null if none does, or if the map itself is not free there.
  const MapZone* zone(Cell cell) const {
    for (const MapZone& zone : data_->zones) {
      if (zone.cells[cell]) return &zone;
    }
    return nullptr;
  }
  /// Adds a zone, as large as the map, whose cells are occupied.
  void add_zone(MapZone zone) { data_.change().zones.push_back(std::move(zone)); }

  /// Changes cells; other copies keep what they were. Cells whose state an edit sets are no longer cells of a
  /// zone. Returns boxes that contain the cells that differ from
  /// before, few and small; none if there are none. Fails as fault_of() does, and changes nothing then.
  /// O(cells of the edit) if no other copy shares the cells, else O(cells) once; the first terrain on a
  /// uniform map takes O(cells) too.
  WEND_API Expected<std::vector<CellBox>, Error> edit(const MapEdit& edit);

 private:
  friend Expected<GridMap, Error> make_grid_map(BitGrid, BitGrid, const Frame&, Grid<double>);

  struct Data {
    BitGrid occupied;
    BitGrid unknown;
    Grid<double> terrain;  // empty if no cell costs more than 1
    Frame frame;
    std::size_t dear_cells;  // that cost more than 1
    std::vector<MapZone> zones = {};
  };

  explicit GridMap(Data data) : data_(std::in_place, std::move(data)) {}

  static void set_terrain(Data& data, Cell cell, double multiplier);
  static void forget_zones(Data& data, const MapEdit& edit);
  static CellBox edit_box(Data& data, const MapEdit& edit);
  static std::vector<Cell> edit_cells(Data& data, const std::vector<CellEdit>& cells);

  CopyOnWrite<Data> data_;
};

/// Makes a map of one cell or more. `terrain` is empty for uniform cost, else as large as `cells`, with
/// every multiplier finite and at least 1. Fails with invalid_map if that is not so, if the map has more
/// than GridMap::kMaxCells cells, if the frame's resolution is not in 1e-9..1e9 m, or if its origin is not finite
/// or 1e12 cells away. O(cells).
WEND_API Expected<GridMap, Error> make_grid_map(const Grid<CellState>& cells,
                                                const Frame& frame = {}, Grid<double> terrain = {});

/// The same from two bit planes of the same size, which must have no set cell in common.
WEND_API Expected<GridMap, Error> make_grid_map(BitGrid occupied, BitGrid unknown,
                                                const Frame& frame = {}, Grid<double> terrain = {});

/// Builds a GridMap row by row, as loaders read files, without more memory than the map needs.
///
///   wend::GridMapBuilder rows(2);
///   rows.append(std::array{wend::CellState::free, wend::CellState::occupied});
///   const auto map = std::move(rows).finish();
class WEND_API GridMapBuilder {
 public:
  /// Rows have `width` cells; finish() fails if that is less than 1.
  explicit GridMapBuilder(int width);

  /// Reserves memory for `height` rows. Without it, memory grows with the rows.
  void reserve(int height);

  /// Appends a row of width() states. `terrain` has a multiplier for each cell, finite and at least 1;
  /// if it is empty, all multipliers are 1. finish() fails after a row of another length.
  void append(std::span<const CellState> states, std::span<const double> terrain = {});

  /// Appends a row of free cells. Set the bits of those that are occupied in the words that it returns, or unknown in
  /// those of last_unknown(): cell x is bit x + 1. Both are valid until the next row is appended.
  std::span<std::uint64_t> append_free();
  /// The unknown cells of the last row.
  std::span<std::uint64_t> last_unknown();

  /// The number of columns.
  int width() const { return occupied_.width(); }
  /// The number of rows so far.
  int height() const { return occupied_.height(); }

  /// Makes the map from one or more rows, or fails as make_grid_map() does. The first appended row is
  /// the top row as drawn: row 0 in a frame with y down, the last row in a frame with y up.
  Expected<GridMap, Error> finish(const Frame& frame = {}) &&;

 private:
  BitGrid occupied_;
  BitGrid unknown_;                 // may lack rows at the end: nothing is unknown there
  int reserved_ = 0;                // rows
  std::vector<double> terrain_;     // of all rows; empty while every cell costs 1
  std::optional<Error> wrong_row_;  // the first
};

}  // namespace wend
