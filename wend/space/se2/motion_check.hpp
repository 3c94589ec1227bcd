#pragma once

// MotionCheck: may the robot of a FreeSpace make a motion, and what does its way cost?
//
// The motion is cut into pieces on which no point of the robot moves farther than a cell. A piece is free if the
// robot at its middle is farther from every obstacle than any of its points moves from there; else it is halved. So
// no obstacle is missed, however thin. Near obstacles the check is conservative by at most kMargin cells, except
// that a disc, a point, and a polygon that does not turn are decided by fits_along(), which is exact.
//
// The multipliers of cells are sampled at the middles of the pieces.

#include <cstdint>
#include <limits>
#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/sweep/footprint_rows.hpp"
#include "wend/space/se2/motion.hpp"
#include "wend/space/se2/outline_clearance.hpp"

namespace wend {

/// What a unit of length costs a robot in a cell, at least 1. As FreeSpace::terrain(), and where the robot's disc does
/// not fit, as where it touches.
inline double driving_multiplier(const FreeSpace& space, Cell cell) {
  const Robot& robot = space.robot();
  const bool squeezed = robot.clearance_distance > 0 && !space.passable()[cell];
  return squeezed ? space.terrain(cell) * (1 + robot.clearance_cost) : space.terrain(cell);
}

/// The cell of a point on the map. Rounds towards zero, which is faster than down.
inline Cell cell_on_map(Point point) {
  return {static_cast<int>(point.x), static_cast<int>(point.y)};
}

class MotionCheck {
 public:
  static constexpr double kBlocked = std::numeric_limits<double>::infinity();
  static constexpr double kMargin = 0.02;  // cells

  /// Keeps a copy of the space.
  explicit MotionCheck(const FreeSpace& space);

  const FreeSpace& free_space() const { return space_; }

  /// The mean multiplier of the cells of the way times its length, in cells; kBlocked if the robot does not fit
  /// somewhere on it. It fits at `from`. O(cells of the way), and more near obstacles.
  double cost(const Pose& from, const Motion& motion) const;

  /// Can the robot make the motion?
  bool fits(const Pose& from, const Motion& motion) const { return cost(from, motion) < kBlocked; }

  /// The same without looking at obstacles: of the part of the way that lies on the map.
  double cost_of_way(const Pose& from, const Motion& motion) const;

  /// The clearance of the base point beyond the circumscribed disc, in cells, or less; negative where the disc does
  /// not fit. The point is on the map or its edge. O(1).
  double room_at(Point point) const;

 private:
  double room_around(const Pose& pose) const;
  int pieces_of(const Motion& motion) const;
  bool on_map(Point point) const {
    return point.x >= 0 && point.y >= 0 && point.x < space_.width() && point.y < space_.height();
  }
  /// The driving multiplier at a point on the map.
  double multiplier_at(Point point) const {
    if (costs_its_length_) return 1;
    const Cell cell = cell_on_map(point);
    if (prices_.empty()) return driving_multiplier(space_, cell);
    return prices_[space_.squared_half_cell_clearance(cell, known_ + 1)];
  }
  void list_prices();
  bool stays_on_map(const Pose& from, const Motion& motion) const;
  bool piece_fits(const Pose& from, const Motion& motion, double half_reach) const;
  bool halves_fit(const Pose& from, const Motion& motion, double half_reach) const;
  bool disc_fits(const Pose& from, const Motion& motion, const Pose& middle, double half_reach,
                 bool& decided) const;
  bool polygon_fits(const Pose& from, const Motion& motion, const Pose& middle, double half_reach,
                    bool& decided) const;

  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

  FreeSpace space_;
  FootprintRows rows_;          // of a polygon
  OutlineClearance clearance_;  // the same, if it is convex
  double circumscribed_;        // cells
  double spin_;                 // how far the farthest corner moves in a turn by a radian, in cells
  std::uint32_t known_;         // distances up to here are at hand, squared and in half-cells
  bool costs_its_length_;       // does nothing cost more, anywhere?
  std::uint32_t clear_ =
      kNever;  // a disc in the cells of this squared clearance is free on a whole piece
  std::vector<double> prices_;  // driving multipliers by squared clearance, if nothing else counts
  double plain_room_;  // with this room beside the robot, nothing costs more than its length
};

}  // namespace wend
