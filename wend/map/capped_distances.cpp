#include "wend/map/capped_distances.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "wend/map/grid_within.hpp"

namespace wend {
namespace {

using Count = std::uint8_t;  // of cells in a column
constexpr std::size_t kBits = 8;
constexpr int kBlock = 64;  // cells of a row that are computed together

/// For each byte of bits, eight bytes that are 0 where a bit is set, else all ones.
constexpr std::array<std::uint64_t, 256> kFreeBytes = [] {
  std::array<std::uint64_t, 256> bytes{};
  for (std::size_t bits = 0; bits < bytes.size(); ++bits) {
    for (std::size_t i = 0; i < kBits; ++i) {
      if ((bits >> i & 1U) == 0) bytes[bits] |= std::uint64_t{0xff} << (8 * i);
    }
  }
  return bytes;
}();

int floor_to_bits(int x) { return x >= 0 ? x / 8 * 8 : -((-x + 7) / 8 * 8); }

}  // namespace

/// Computes the distances in a window of the map: first those within the columns, from the bits of the
/// rows in reach, and then those over the rows. Its columns are bytes of bits of the rows (column x is bit
/// x+1), so that they are read 8 at a time.
class CappedDistances::Window {
 public:
  Window(const BitGrid& blocked, bool edge_counts, int cap, const CellBox& cells)
      : blocked_(blocked),
        edge_counts_(edge_counts),
        cap_(cap),
        cells_(cells),
        first_bit_(floor_to_bits(cells.begin.x + 1 - cap)),
        width_(static_cast<std::size_t>(floor_to_bits(cells.end.x + 1 + cap + kBlock + 7) -
                                        first_bit_)),
        map_(width_),
        free_(width_),
        running_(width_),
        squares_(width_),
        row_(static_cast<std::size_t>(cells.width() + kBlock)),
        columns_(width_ * static_cast<std::size_t>(cells.height())) {
    for (std::size_t i = 0; i < width_; ++i) {
      const int x = first_bit_ + static_cast<int>(i) - 1;
      map_[i] = !edge_counts || (x >= 0 && x < blocked.width()) ? 0xff : 0;
    }
  }

  /// Calls take(y, row) with the squared distances of every row of the window, the last one first.
  template <class Take>
  void run(Take&& take, DeadlineCheck& stop = DeadlineCheck::never()) {
    start();
    for (int y = cells_.begin.y - cap_; y < cells_.end.y && !stop.now(); ++y) {
      go_to_row(y);
      if (y >= cells_.begin.y) std::ranges::copy(running_, column_row(y).begin());
    }
    start();
    for (int y = cells_.end.y - 1 + cap_; y >= cells_.begin.y && !stop.now(); --y) {
      go_to_row(y);
      if (y < cells_.end.y) take(y, squared_row(y));
    }
  }

 private:
  std::span<Count> column_row(int y) {
    return std::span(columns_).subspan(static_cast<std::size_t>(y - cells_.begin.y) * width_,
                                       width_);
  }

  /// Nothing is near.
  void start() { std::ranges::fill(running_, static_cast<Count>(cap_ + 1)); }

  /// One more cell from all obstacles, and 0 in those of this row.
  void go_to_row(int y) {
    const bool on_map = y >= 0 && y < blocked_.height();
    if (!on_map && edge_counts_) {
      std::ranges::fill(running_, Count{0});
      return;
    }
    read_row(on_map ? blocked_.row_words(y) : std::span<const std::uint64_t>());
    const auto most = static_cast<Count>(cap_ + 1);
    for (std::size_t i = 0; i < width_; ++i) {
      const auto one_more = static_cast<Count>(running_[i] + 1);
      running_[i] = static_cast<Count>(std::min(one_more, most) & free_[i] & map_[i]);
    }
  }

  /// Sets free_ from the words of a row; without words everything is free.
  void read_row(std::span<const std::uint64_t> words) {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(words.data());
    const auto end = static_cast<std::ptrdiff_t>(words.size() * sizeof(std::uint64_t));
    const std::ptrdiff_t first = first_bit_ / 8;
    for (std::size_t i = 0; i < width_ / kBits; ++i) {
      const std::ptrdiff_t byte = first + static_cast<std::ptrdiff_t>(i);
      const std::uint64_t free = kFreeBytes[byte >= 0 && byte < end ? bytes[byte] : 0];
      std::memcpy(free_.data() + kBits * i, &free, sizeof free);
    }
  }

  /// The distances of a row, from the window's first column on.
  std::span<const Squared> squared_row(int y) {
    const auto above = column_row(y);
    for (std::size_t i = 0; i < width_; ++i) {
      const auto cells = static_cast<Squared>(std::min(running_[i], above[i]));
      const auto half_cells = static_cast<Squared>(2 * cells - 1);
      squares_[i] = cells == 0 ? Squared{0} : static_cast<Squared>(half_cells * half_cells);
    }
    const auto offset = static_cast<std::size_t>(cells_.begin.x + 1 - first_bit_);
    const auto width = static_cast<std::size_t>(cells_.width());
    for (std::size_t x = 0; x < width; x += kBlock) {
      compute_block(squares_.data() + offset + x, row_.data() + x);
    }
    return std::span(row_).first(width);
  }

  /// The least, over the columns to both sides, of the squares of both distances. Stops where no column
  /// farther away can be nearer.
  void compute_block(const Squared* squares, Squared* out) const {
    std::array<Squared, kBlock> least{};
    std::copy_n(squares, kBlock, least.begin());
    for (int k = 1; k <= cap_; ++k) {
      const auto aside = static_cast<Squared>((2 * k - 1) * (2 * k - 1));
      Squared most = 0;
      for (const Squared here : least) most = std::max(most, here);
      if (aside >= most) break;
      const Squared* const left = squares - k;
      const Squared* const right = squares + k;
      for (std::size_t i = 0; i < kBlock; ++i) {
        const auto other = static_cast<Squared>(std::min(left[i], right[i]) + aside);
        least[i] = std::min(least[i], other);
      }
    }
    std::ranges::copy(least, out);
  }

  const BitGrid& blocked_;
  bool edge_counts_;
  int cap_;
  CellBox cells_;
  int first_bit_;               // of the columns in reach
  std::size_t width_;           // the number of these columns, and some more
  std::vector<Count> map_;      // all ones in columns that are not an edge that counts
  std::vector<Count> free_;     // all ones in free cells of the present row
  std::vector<Count> running_;  // cells to the nearest obstacle among the rows so far
  std::vector<Squared> squares_;
  std::vector<Squared> row_;
  std::vector<Count> columns_;  // what running_ was, going down
};

CappedDistances::CappedDistances(const BitGrid& blocked, bool edge_counts, int cap,
                                 DeadlineCheck& stop)
    : cap_(cap),
      edge_counts_(edge_counts),
      squared_(grid_within<Squared>(blocked.width(), blocked.height(), 0, stop)) {
  assert(cap >= 1 && cap <= kLargestCap);
  constexpr int kCellsOfBand = 1 << 20;  // what a cache holds
  const int rows = std::max(kCellsOfBand / std::max(blocked.width(), 1), 4 * cap);
  for (int begin = 0; begin < blocked.height() && !stop.has_passed(); begin += rows) {
    const int end = std::min(begin + rows, blocked.height());
    Window window(blocked, edge_counts, cap, {{0, begin}, {blocked.width(), end}});
    window.run(
        [&](int y, std::span<const Squared> row) {
          std::ranges::copy(row, squared_.row(y).begin());
        },
        stop);
  }
}

CellBox CappedDistances::repair(const BitGrid& blocked, const CellBox& edited) {
  const CellBox reach = edited.grown_by(cap_).clipped_to(squared_);
  CellBox changed{reach.end, reach.begin};
  Window window(blocked, edge_counts_, cap_, reach);
  window.run([&](int y, std::span<const Squared> row) {
    const auto old = squared_.row(y).subspan(static_cast<std::size_t>(reach.begin.x), row.size());
    const auto first = std::ranges::mismatch(row, old).in1;
    if (first == row.end()) return;
    const auto differs = [&](std::size_t i) { return row[i] != old[i]; };
    std::size_t end = row.size();
    while (!differs(end - 1)) --end;
    const int begin_x = reach.begin.x + static_cast<int>(first - row.begin());
    const int end_x = reach.begin.x + static_cast<int>(end);
    changed.begin = {std::min(changed.begin.x, begin_x), std::min(changed.begin.y, y)};
    changed.end = {std::max(changed.end.x, end_x), std::max(changed.end.y, y + 1)};
    std::ranges::copy(row, old.begin());
  });
  return changed.empty() ? CellBox{} : changed;
}

void CappedDistances::select(std::uint32_t least, const CellBox& box, BitGrid& cells,
                             DeadlineCheck& stop) const {
  assert(least <= far());
  const auto threshold = static_cast<Squared>(least);
  for (int y = box.begin.y; y < box.end.y && !stop.now(); ++y) {
    const auto values = squared_.row(y).subspan(static_cast<std::size_t>(box.begin.x),
                                                static_cast<std::size_t>(box.width()));
    assign_row(cells.row_words(y), box.begin.x, values,
               [threshold](Squared squared) { return squared >= threshold; });
  }
}

}  // namespace wend
