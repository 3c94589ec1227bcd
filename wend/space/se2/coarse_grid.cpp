#include "wend/space/se2/coarse_grid.hpp"

#include <algorithm>
#include <bit>
#include <numbers>

#include "wend/geometry/trigonometry.hpp"
#include "wend/map/row_bits.hpp"
#include "wend/robot/disc_ring.hpp"
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

/// Lowers a multiplier to the least of the set cells in a box.
void take_multipliers(const FreeSpace& space, const BitGrid& cells, const CellBox& box,
                      float& least) {
  for (int y = box.begin.y; y < box.end.y && least > 1; ++y) {
    auto bits = row_bits(cells.row_words(y), box.begin.x, box.width());
    for (; bits != 0 && least > 1; bits &= bits - 1) {
      const Cell cell{box.begin.x + std::countr_zero(bits), y};
      least = std::min(least, static_cast<float>(driving_multiplier(space, cell)));
    }
  }
}

/// Calls visit(y) for every `step`-th row of cells, and asks stop() every some ten thousand cells whether it must end.
template <class Visit>
void for_each_row(const FreeSpace& space, int step, const std::function<bool()>& stop,
                  Visit&& visit) {
  constexpr int kCellsBetweenLooks = 1 << 16;
  const int rows = std::max(kCellsBetweenLooks / space.width() / step, 1) * step;
  for (int y = 0; y < space.height(); y += step) {
    visit(y);
    if ((y + step) % rows == 0 && stop()) return;
  }
}

/// Does a unit of length cost the same in every cell?
bool costs_nothing_more(const FreeSpace& space) {
  const Robot& robot = space.robot();
  return space.uniform_terrain() && !(robot.clearance_distance > 0 && robot.clearance_cost > 0);
}

}  // namespace

BitGrid cells_to_drive_in(const FreeSpace& space) {
  if (!space.footprint().covers_base_point()) {
    const Point centre = space.footprint().inner_disc().centre;
    const double away = hypotenuse(centre.x, centre.y) / space.map().frame().resolution;
    BitGrid cells(space.width(), space.height());
    DiscRing(away, BasePlace::anywhere)
        .spread(space.inner_disc_cells(), space.outside() == OutsidePolicy::free,
                CellBox::of(cells), cells);
    return cells;
  }
  const double radius = space.inscribed_radius_in_cells() - kHalfDiagonal;
  constexpr double kRounding = 1e-6;
  const double least = 4 * radius * radius - kRounding;
  if (radius <= 0 || least <= 1) return space.obstacles().blocked().complement();
  return space.cells_clear_by(least);
}

CoarseGrid::CoarseGrid(const FreeSpace& space, const BitGrid& drivable, int size,
                       const std::function<bool()>& stop)
    : size_(size), stride_(static_cast<std::size_t>((space.width() + size - 1) / size) + 2) {
  const auto rows = static_cast<std::size_t>((space.height() + size - 1) / size) + 2;
  multipliers_.assign(stride_ * rows, std::numeric_limits<float>::infinity());
  sides_.assign(stride_ * rows, 0);
  for_each_row(space, size, stop, [&](int y) { take_rows(space, drivable, y); });
}

/// Takes the squares whose first row is y: 64 cells of a row at a time, as far as that goes.
void CoarseGrid::take_rows(const FreeSpace& space, const BitGrid& drivable, int y) {
  const int end = std::min(y + size_, space.height());
  std::vector<std::uint64_t> any(drivable.row_words(y).size(), 0);  // cells of any row
  std::vector<std::uint64_t> across(any.size(), 0);                 // and the next cell with them
  for (int at = y; at < end; ++at) {
    const auto row = drivable.row_words(at);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::uint64_t next = i + 1 < row.size() ? row[i + 1] : 0;
      any[i] |= row[i];
      across[i] |= row[i] & (row[i] >> 1U | next << 63U);
    }
  }
  const bool same = costs_nothing_more(space);
  std::size_t square = index(0, y / size_);
  for (int x = 0; x < space.width(); x += size_, ++square) {
    if (row_bits(any, x, size_) == 0) continue;
    if (same) {
      multipliers_[square] = 1;
    } else {
      take_multipliers(space, drivable, {{x, y}, {x + size_, end}}, multipliers_[square]);
    }
    if (row_bits(across, x + size_ - 1, 1) != 0) {
      sides_[square] |= kRight;
      sides_[square + 1] |= kLeft;
    }
    if (end < space.height() && (row_bits(drivable.row_words(end - 1), x, size_) &
                                 row_bits(drivable.row_words(end), x, size_)) != 0) {
      sides_[square] |= kAbove;
      sides_[square + stride_] |= kBelow;
    }
  }
}

void CoarseGrid::charge_narrow_squares(const FreeSpace& space, double room, float factor,
                                       const std::function<bool()>& stop) {
  const double least = space.inscribed_radius_in_cells() + room;
  const auto threshold = threshold_of(4 * least * least);
  std::vector<bool> wide(count(), false);
  for_each_row(space, 1, stop, [&](int y) {
    const auto row = space.possible().row_words(y);
    std::size_t square = index(0, y / size_);
    for (int x = 0; x < space.width(); x += size_, ++square) {
      for (auto cells = row_bits(row, x, size_); cells != 0 && !wide[square]; cells &= cells - 1) {
        const Cell cell{x + std::countr_zero(cells), y};
        wide[square] = space.squared_half_cell_clearance(cell, threshold) >= threshold;
      }
    }
  });
  for (std::size_t i = 0; i < count(); ++i) {
    if (!wide[i]) multipliers_[i] *= factor;
  }
}

}  // namespace wend
