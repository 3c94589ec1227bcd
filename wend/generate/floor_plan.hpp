#pragma once

// FloorPlan: a building as a robot's map shows it. Walls are drawn where floors end; what stands on
// the floor is an outline with unknown cells inside, as a laser scanner sees it; all around the
// building is unknown. Lengths are cells, of 0.1 m each.

#include <span>

#include "wend/generate/block.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

class FloorPlan {
 public:
  static constexpr double kMetresPerCell = 0.1;
  static constexpr int kOuterWall = 3;
  static constexpr int kInnerWall = 2;  // between two floors

  /// The distance from the map's edge to the floor of a building that fills the map: a strip of the
  /// outside, and the outer wall.
  static constexpr int kMargin = 3 + kOuterWall;

  /// The distance of start and goal from the map's edge; the floor around them is free.
  static constexpr int kFreeCorner = 10;

  FloorPlan(int width, int height);

  /// Draws floors, and walls around all of them.
  void build(std::span<const Block> floors);

  /// Cuts windows into those parts of a floor's walls that border the outside.
  void cut_windows(const Block& floor);

  /// Cuts one window, or a closed gate: two panes with unknown cells between them. `inner` is the row
  /// of wall cells next to the floor. Does nothing if there is no outer wall.
  void cut_window(const Block& inner, Cell outwards);

  /// Opens a door in walls.
  void open(const Block& door) { fill(cells_, door, CellState::free); }

  /// Keeps a block free of furniture.
  void keep_free(const Block& block) { fill(kept_free_, block, kKeptFree); }

  void draw_wall(const Block& wall) { fill(cells_, wall, CellState::occupied); }

  /// Puts a piece of furniture on the floor; false if it does not fit there.
  bool place(const Block& piece);

  /// The same for a round piece: all cells within `radius` of the centre along a circle.
  bool place_round(Cell centre, int radius);

  const Grid<CellState>& cells() const { return cells_; }

  /// Mirrors the plan at its diagonal: x becomes y.
  void transpose();

  /// The plan as a map, y up, its lower left corner at (0, 0) m.
  GridMap map() const;

 private:
  static constexpr unsigned char kKeptFree = 1;

  bool is_outside(Cell cell) const;

  Grid<CellState> cells_;
  Grid<unsigned char> kept_free_;
};

}  // namespace wend
