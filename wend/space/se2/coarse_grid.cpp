#include "wend/space/se2/coarse_grid.hpp"

#include <algorithm>
#include <bit>
#include <numbers>

#include "wend/space/se2/motion_check.hpp"

namespace wend {
namespace {

/// How far a point of a cell may be from its centre.
constexpr double kHalfDiagonal = std::numbers::sqrt2 / 2;

/// A squared distance in half-cells, rounded up; the largest stands for all that are larger.
std::uint32_t threshold_of(double squared) {
  constexpr double kMost = 4e9;
  return static_cast<std::uint32_t>(std::ceil(std::min(squared, kMost)));
}

/// Calls visit(x) for the set bits of a row.
template <class Visit>
void for_each_cell(std::span<const std::uint64_t> words, Visit&& visit) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (std::uint64_t bits = words[i]; bits != 0; bits &= bits - 1) {
      visit(static_cast<int>(64 * i) + std::countr_zero(bits) - 1);
    }
  }
}

}  // namespace

BitGrid cells_to_drive_in(const FreeSpace& space) {
  const double radius = space.inscribed_radius_in_cells() - kHalfDiagonal;
  constexpr double kRounding = 1e-6;
  const double least = 4 * radius * radius - kRounding;
  if (radius <= 0 || least <= 1) return space.obstacles().blocked().complement();
  const auto threshold = threshold_of(least);
  BitGrid cells = space.possible();
  std::vector<std::uint64_t> open;
  for (int y = 0; y < space.height(); ++y) {
    const auto row = cells.row_words(y);
    const auto blocked = space.obstacles().blocked().row_words(y);
    open.assign(row.size(), 0);
    for (std::size_t i = 0; i < row.size(); ++i) open[i] = ~row[i] & ~blocked[i];
    for_each_cell(open, [&](int x) {
      const Cell cell{x, y};
      if (!space.contains(cell)) return;
      if (space.squared_half_cell_clearance(cell, threshold) >= threshold) cells.set(cell, true);
    });
  }
  return cells;
}

int coarse_size(const FreeSpace& space, double most) {
  // A wall is as thick as the cells of a line through it that are closed for the robot.
  const double wall = 2 * (space.inscribed_radius_in_cells() - kHalfDiagonal) + 1;
  const double thickest = std::min(wall / std::numbers::sqrt2, most);
  return std::max(1, static_cast<int>(std::lround(thickest)));
}

CoarseGrid::CoarseGrid(const FreeSpace& space, const BitGrid& drivable, int size)
    : size_(size), stride_(static_cast<std::size_t>((space.width() + size - 1) / size) + 2) {
  const auto rows = static_cast<std::size_t>((space.height() + size - 1) / size) + 2;
  multipliers_.assign(stride_ * rows, std::numeric_limits<float>::infinity());
  sides_.assign(stride_ * rows, 0);
  for (int y = 0; y < space.height(); ++y) take_row(space, drivable, y);
}

void CoarseGrid::take_row(const FreeSpace& space, const BitGrid& drivable, int y) {
  const bool last_row = y % size_ == size_ - 1 && y + 1 < space.height();
  const std::size_t first = index(0, y / size_);
  for_each_cell(drivable.row_words(y), [&](int x) {
    const std::size_t square = first + static_cast<std::size_t>(x / size_);
    const auto multiplier = static_cast<float>(driving_multiplier(space, {x, y}));
    multipliers_[square] = std::min(multipliers_[square], multiplier);
    if (x % size_ == size_ - 1 && drivable[{x + 1, y}]) {
      sides_[square] |= kRight;
      sides_[square + 1] |= kLeft;
    }
    if (last_row && drivable[{x, y + 1}]) {
      sides_[square] |= kAbove;
      sides_[square + stride_] |= kBelow;
    }
  });
}

void CoarseGrid::charge_narrow_squares(const FreeSpace& space, double room, float factor) {
  const double least = space.inscribed_radius_in_cells() + room;
  const auto threshold = threshold_of(4 * least * least);
  std::vector<bool> wide(count(), false);
  for (int y = 0; y < space.height(); ++y) {
    for_each_cell(space.possible().row_words(y), [&](int x) {
      const std::size_t square = index(x / size_, y / size_);
      if (wide[square]) return;
      const std::uint32_t clear = space.squared_half_cell_clearance(Cell{x, y}, threshold);
      wide[square] = clear >= threshold;
    });
  }
  for (std::size_t i = 0; i < count(); ++i) {
    if (!wide[i]) multipliers_[i] *= factor;
  }
}

}  // namespace wend
