#pragma once

// CoarseGrid: a map cut into squares of several cells, for estimates of the cost to a goal: where the middle of a
// robot can be, what a unit of length costs there at least, and which neighbours are connected.
//
// A square is open if the robot's base point may be in one of its cells at some heading. Two squares are connected
// if such cells meet across their common edge. So no wall is lost that is at least as thick as a square.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The cells in which the base point can be somewhere, not only in the middle, at some heading. Two of them that a
/// robot can drive between are connected by common edges. Where the base point lies outside the robot's polygon,
/// blocked cells may be among them. O(cells / 64 + cells near obstacles), and for such a robot O(cells / 64) for each
/// cell of its DiscRing.
BitGrid cells_to_drive_in(const FreeSpace& space);

class CoarseGrid {
 public:
  static constexpr int kMostSize = 63;  // cells

  /// `size` is that of a square, in cells. O(cells). stop() is asked now and then whether it must end; if it said so, it
  /// is of no use.
  CoarseGrid(
      const FreeSpace& space, const BitGrid& drivable, int size,
      const std::function<bool()>& stop = [] { return false; });

  int size() const { return size_; }
  /// The number of squares with a ring of blocked ones around the map.
  std::size_t count() const { return multipliers_.size(); }
  /// From a square to the one above it.
  std::size_t stride() const { return stride_; }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row + 1) * stride_ + static_cast<std::size_t>(column + 1);
  }
  /// The middle of a square.
  Point middle(std::size_t square) const {
    const std::size_t column = square % stride_;
    const std::size_t row = square / stride_;
    return {(static_cast<double>(column) - 0.5) * size_, (static_cast<double>(row) - 0.5) * size_};
  }

  int columns() const { return static_cast<int>(stride_) - 2; }
  int rows() const { return static_cast<int>(count() / stride_) - 2; }

  /// The least multiplier in a square; infinite if it is blocked.
  float multiplier(std::size_t square) const { return multipliers_[square]; }
  bool open(std::size_t square) const {
    return multipliers_[square] < std::numeric_limits<float>::infinity();
  }

  /// The sides on which a square is connected with the next one, as flags.
  std::uint8_t sides(std::size_t square) const { return sides_[square]; }
  static constexpr std::uint8_t kRight = 1;
  static constexpr std::uint8_t kLeft = 2;
  static constexpr std::uint8_t kAbove = 4;
  static constexpr std::uint8_t kBelow = 8;

  /// Makes squares dearer in which no cell has this room beside the robot, in cells.
  void charge_narrow_squares(
      const FreeSpace& space, double room, float factor,
      const std::function<bool()>& stop = [] { return false; });

 private:
  void take_rows(const FreeSpace& space, const BitGrid& drivable, int y);

  int size_;
  std::size_t stride_;
  std::vector<float> multipliers_;
  std::vector<std::uint8_t> sides_;
};

}  // namespace wend
