#pragma once

// SweptCells: the cells that a robot sweeps on a motion, found once and compared with the obstacles often:
// a motion primitive fits where none of its cells is blocked.
//
//   const std::vector<wend::Pose> poses{{0.5, 0.5, 0}, {4.5, 0.5, 0}};
//   const wend::SweptCells swept(space, poses);
//   if (wend::fits(space, swept, {3, 7})) ...  // the same motion from cell (3,7)
//
// Motions lead along segments between poses in grid coordinates; the first lies in cell (0, 0).
//
// - A disc sweeps the cells whose closed squares are nearer than its radius: exact.
// - A point sweeps those that its way enters or touches: it also keeps off corners, like a grid planner
//   that cuts none.
// - A polygon sweeps those whose interior it overlaps. Along lines this is exact; where it turns, a cell
//   also counts that it only comes closer to than kSweepTolerance: fits_along() finds such motions free.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/geometry/box.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

inline constexpr double kSweepTolerance = 0.06;  // cells

class SweptCells {
 public:
  /// Up to 64 cells of a row.
  struct Run {
    int dx;
    int dy;
    std::uint64_t cells;  // bit i: the cell dx + i
  };

  /// For the robot of the space, on any map. At least one pose, no segment turns by more than half a
  /// circle. O(cells near the way); for a polygon that turns, times its corners and the logarithm of the
  /// tolerance.
  SweptCells(const FreeSpace& space, std::span<const Pose> poses);

  std::span<const Run> runs() const { return runs_; }

  /// The least rectangle of cells around all swept cells and the base point's way.
  Cell low() const { return low_; }
  Cell high() const { return high_; }

  /// The same for the base point's way alone.
  Cell way_low() const { return way_low_; }
  Cell way_high() const { return way_high_; }

  /// Half-cells, squared: where the nearest obstacle is at least so far from the middle of cell (0, 0),
  /// the robot touches none.
  std::uint32_t reach() const { return reach_; }

 private:
  std::vector<Run> runs_;
  Cell low_{};
  Cell high_{};
  Cell way_low_{};
  Cell way_high_{};
  std::uint32_t reach_ = 0;
};

/// May the robot make this motion from a cell of the map? The base point stays on the map, and the
/// shape too if the outside is blocked. O(1) far from obstacles, else O(runs).
bool fits(const FreeSpace& space, const SweptCells& swept, Cell from);

}  // namespace wend
