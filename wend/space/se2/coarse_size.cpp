#include "wend/space/se2/coarse_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "wend/map/row_bits.hpp"
#include "wend/space/se2/coarse_grid.hpp"

namespace wend {
namespace {

/// From the centre of a cell to its corner.
constexpr double kToCorner = std::numbers::sqrt2 / 2;

/// The cells of a square are the bits of a word: rows of eight.
constexpr int kRow = 8;
constexpr std::uint64_t kLeftColumn = 0x0101010101010101;

/// Are cells of a square not connected with each other by common edges within it?
bool falls_apart(std::uint64_t cells) {
  std::uint64_t reached = cells & -cells;
  for (std::uint64_t before = 0; before != reached;) {
    before = reached;
    const std::uint64_t right = (reached & ~(kLeftColumn << (kRow - 1))) << 1;
    const std::uint64_t left = (reached & ~kLeftColumn) >> 1;
    reached |= (right | left | reached << kRow | reached >> kRow) & cells;
  }
  return reached != cells;
}

/// The cells of a square whose lower left one is given.
std::uint64_t square_at(const BitGrid& drivable, Cell first, int size) {
  const int height = std::min(size, drivable.height() - first.y);
  std::uint64_t cells = 0;
  for (int i = 0; i < height; ++i) {
    cells |= row_bits(drivable.row_words(first.y + i), first.x, size) << (kRow * i);
  }
  return cells;
}

/// Some rows, 64 cells at a time: the columns in which any cell is set, and those in which all are.
class Columns {
 public:
  Columns(const BitGrid& cells, int first, int count)
      : any_(cells.row_words(first).size(), 0), all_(any_.size(), ~std::uint64_t{0}) {
    const int end = std::min(first + count, cells.height());
    for (int y = first; y < end; ++y) {
      const auto row = cells.row_words(y);
      for (std::size_t i = 0; i < row.size(); ++i) {
        any_[i] |= row[i];
        all_[i] &= row[i];
      }
    }
  }

  bool is_empty(int x, int count) const { return row_bits(any_, x, count) == 0; }
  bool is_full(int x, int count) const {
    return row_bits(all_, x, count) == (std::uint64_t{1} << count) - 1;
  }

 private:
  std::vector<std::uint64_t> any_;
  std::vector<std::uint64_t> all_;
};

/// Does hardly any square of this size fall apart?
bool keeps_walls(const BitGrid& drivable, int size) {
  constexpr std::size_t kOneOf = 1000;
  const int columns = (drivable.width() + size - 1) / size;
  const int rows = (drivable.height() + size - 1) / size;
  const std::size_t most =
      static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) / kOneOf;
  std::size_t open = 0;
  std::size_t apart = 0;
  for (int y = 0; y < drivable.height(); y += size) {
    const Columns band(drivable, y, size);
    for (int x = 0; x < drivable.width(); x += size) {
      if (band.is_empty(x, size)) continue;
      ++open;
      if (band.is_full(x, size)) continue;
      if (falls_apart(square_at(drivable, {x, y}, size)) && ++apart > most) return false;
    }
  }
  return kOneOf * apart <= open;
}

}  // namespace

int coarse_size(const FreeSpace& space, const BitGrid& drivable, double most) {
  // A wall is as thick as the cells of a line through it that are closed for the robot.
  const double wall = 2 * (space.inscribed_radius_in_cells() - kToCorner) + 1;
  most = std::min<double>(most, CoarseGrid::kMostSize);
  const auto by_radius = static_cast<int>(std::lround(std::min(wall / std::numbers::sqrt2, most)));
  int size = std::min(kRow, static_cast<int>(std::lround(most)));
  while (size > std::max(1, by_radius) && !keeps_walls(drivable, size)) --size;
  return std::max({1, size, by_radius});
}

}  // namespace wend
