#include "wend/robot/disc_ring.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

/// As bits_from(), also from before the row.
std::uint64_t bits_around(std::span<const std::uint64_t> row, std::ptrdiff_t bit) {
  const std::ptrdiff_t word = bit >= 0 ? bit / 64 : -((63 - bit) / 64);
  const auto shift = static_cast<unsigned>(bit - 64 * word);
  const auto at = [&](std::ptrdiff_t i) {
    const bool exists = i >= 0 && i < static_cast<std::ptrdiff_t>(row.size());
    return exists ? row[static_cast<std::size_t>(i)] : 0;
  };
  return shift == 0 ? at(word) : at(word) >> shift | at(word + 1) << (64 - shift);
}

/// The bits of a word of a row that stand for cells from `begin` to `end`: the bit of cell x is x + 1.
std::uint64_t bits_of_cells(std::size_t word, int begin, int end) {
  const auto first =
      std::max<std::ptrdiff_t>(begin + 1 - 64 * static_cast<std::ptrdiff_t>(word), 0);
  const auto last = std::min<std::ptrdiff_t>(end + 1 - 64 * static_cast<std::ptrdiff_t>(word), 64);
  if (first >= last) return 0;
  return (~std::uint64_t{0} >> (64 - (last - first))) << first;
}

}  // namespace

DiscRing::DiscRing(double distance, BasePlace place) {
  constexpr double kRounding = 1e-6;
  const double half = (place == BasePlace::middle ? 0.5 : 1) + kRounding;  // of both cells
  if (!(distance + half < kMostReach)) {
    reach_ = kMostReach;
    return;
  }
  reach_ = static_cast<int>(std::ceil(distance + half)) - 1;
  const auto nearest = [half](int cells) { return std::max(cells - half, 0.0); };
  for (int dy = 0; dy <= reach_; ++dy) {
    Columns columns{0, -1};
    for (int dx = 0; dx <= reach_; ++dx) {
      if (hypotenuse(dx + half, dy + half) < distance) columns.first = dx + 1;
      if (hypotenuse(nearest(dx), nearest(dy)) <= distance) columns.last = dx;
    }
    rows_.push_back(columns);
  }
}

void DiscRing::spread(const BitGrid& centres, bool outside, const CellBox& box,
                      BitGrid& cells) const {
  const CellBox inside = outside ? CellBox::of(cells).grown_by(-reach_) : CellBox::of(cells);
  const std::size_t end = static_cast<std::size_t>(box.end.x) / 64;
  for (int y = box.begin.y; y < box.end.y; ++y) {
    const bool whole_row = rows_.empty() || y < inside.begin.y || y >= inside.end.y;
    const auto words = cells.row_words(y);
    for (std::size_t i = (static_cast<std::size_t>(box.begin.x) + 1) / 64; i <= end; ++i) {
      const std::uint64_t all = bits_of_cells(i, 0, cells.width());
      std::uint64_t bits = whole_row ? all : all & ~bits_of_cells(i, inside.begin.x, inside.end.x);
      for (int dy = -reach_; dy <= reach_ && bits != all; ++dy) {
        if (y + dy < 0 || y + dy >= centres.height()) continue;
        bits |= all & on_row(centres.row_words(y + dy), i, std::abs(dy));
      }
      words[i] = bits;
    }
  }
}

/// The cells of a word with a centre on their ring in one row.
std::uint64_t DiscRing::on_row(std::span<const std::uint64_t> centres, std::size_t word,
                               int distance) const {
  const Columns& columns = rows_[static_cast<std::size_t>(distance)];
  const auto first = 64 * static_cast<std::ptrdiff_t>(word);
  std::uint64_t bits = 0;
  for (int dx = columns.first; dx <= columns.last; ++dx) {
    bits |= bits_around(centres, first + dx) | bits_around(centres, first - dx);
  }
  return bits;
}

}  // namespace wend
