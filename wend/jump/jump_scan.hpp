#pragma once

// JumpScan: finds jump points on the cells of a map, without anything prepared.
//
// A straight scan compares the words of three neighbouring lines of cells: a run stops at a blocked cell, or
// beside a free cell that a blocked one comes before, which makes it a jump point (jump_boards.hpp). It reads
// some 60 cells at a time. A diagonal run goes step by step and scans to both sides. JumpGraph on JumpBoards
// finds the same jumps, in the same order, faster, but first reads the whole map.
//
//   wend::JumpScan scan(space.passable());
//   scan.visit_jumps(cell, 0xFF, [&](const wend::ScannedJump& jump) { return use(jump); });
//
// One thread.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/jump/block_directions.hpp"
#include "wend/jump/column_tiles.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

/// A jump point, and the straight direction in which a jump arrives there.
struct ScannedJump {
  Cell cell;
  unsigned arrival = 0;  // 0 to 3 for +y, +x, -y and -x

  friend bool operator==(const ScannedJump&, const ScannedJump&) = default;
};

class JumpScan {
 public:
  /// `passable` must live as long.
  explicit JumpScan(const BitGrid& passable)
      : passable_(&passable),
        rows_(passable.row_words(0).data()),
        row_words_(static_cast<std::ptrdiff_t>(passable.row_words(0).size())),
        columns_(passable) {}

  int width() const { return passable_->width(); }
  int height() const { return passable_->height(); }
  bool passable(Cell cell) const { return (*passable_)[cell]; }

  /// The directions in which a path leaves a jump point: straight on, and past the obstacles beside it.
  DirectionSet directions(const ScannedJump& jump) const {
    return BlockDirections::kLeaving[jump.arrival][passable_->block(jump.cell)];
  }

  /// Calls visit(jump) for the next jump points from a cell in these directions, until it returns false.
  template <class Visit>
  void visit_jumps(Cell from, DirectionSet directions, Visit&& visit);

  /// Is the path between two cells that takes its diagonal steps first, then its straight steps, free? As
  /// Sight::sees().
  bool sees(Cell from, Cell to);

  /// Is there a jump point on the straight part of that path, before its end? For cells in sight.
  bool passes_jump(Cell from, Cell to);

  /// Reads the cells of a box anew, because they have changed.
  void forget(const CellBox& box) { columns_.forget(box); }

  /// The number of scans so far: a measure of the time spent.
  std::uint64_t scans() const { return scans_; }

 private:
  using Word = std::uint64_t;

  /// Where a run stops.
  struct Stop {
    int steps;
    bool jumps;  // at a jump point, else before a blocked cell
  };

  /// Cells of the line of a run, and of the lines beside it. The first is where the run starts: the lowest bit
  /// of a run towards greater numbers, the highest one of other runs.
  struct Windows {
    Word here;
    Word one;
    Word other;
  };

  static constexpr int kWindow = 57;  // cells that a window is sure to hold

  static constexpr bool is_along_rows(Direction straight) {
    return straight == Direction::plus_x || straight == Direction::minus_x;
  }
  static constexpr bool is_ahead(Direction straight) {
    return straight == Direction::plus_x || straight == Direction::plus_y;
  }

  /// The words of a row, or of a column that was prepared.
  template <bool kRow>
  const Word* line(int number) const {
    if constexpr (kRow) return rows_ + number * row_words_;
    return columns_.line(number);
  }
  template <bool kAhead>
  static Word window(const Word* line, int at);
  template <bool kAhead>
  static Word next_cells(Word window) {
    return kAhead ? window >> 1U : window << 1U;
  }
  template <bool kAhead>
  static Word stops(const Windows& windows);

  template <Direction kStraight>
  Stop scan_far(Cell from);
  template <Direction kStraight, class Visit>
  bool visit_stop(Cell from, const Windows& windows, Visit& visit);
  template <Direction kStraight, class Visit>
  bool shoot(Cell from, Visit& visit);
  template <Direction kDiagonal, class Visit>
  bool sweep(Cell from, Visit& visit);
  template <Direction kStraight>
  bool is_free(Cell from, int steps);
  bool diagonal_is_free(Cell from, Cell to) const;

  const BitGrid* passable_;
  const std::uint64_t* rows_;  // of row 0
  std::ptrdiff_t row_words_;
  ColumnTiles columns_;
  std::uint64_t scans_ = 0;
};

/// Reads a line from a cell on, or back from it: kWindow cells or more.
template <bool kAhead>
[[gnu::always_inline]] inline JumpScan::Word JumpScan::window(const Word* line, int at) {
  const int bit = at + 1;
  const int byte = kAhead ? bit / 8 : std::max(bit / 8 - 7, 0);
  Word word = 0;
  std::memcpy(&word, reinterpret_cast<const unsigned char*>(line) + byte, sizeof word);
  return kAhead ? word >> (bit - 8 * byte) : word << (63 - (bit - 8 * byte));
}

/// The cells where a run stops.
template <bool kAhead>
[[gnu::always_inline]] inline JumpScan::Word JumpScan::stops(const Windows& windows) {
  const auto turns = [](Word side) { return side & ~(kAhead ? side << 1U : side >> 1U); };
  constexpr Word kStart = kAhead ? 1 : Word{1} << 63U;
  return (~windows.here | turns(windows.one) | turns(windows.other)) & ~kStart;
}

template <Direction kStraight>
[[gnu::noinline]] JumpScan::Stop JumpScan::scan_far(Cell from) {
  constexpr bool kRow = is_along_rows(kStraight);
  constexpr bool kAhead = is_ahead(kStraight);
  const int number = kRow ? from.y : from.x;
  const Word* const here = line<kRow>(number);
  const Word* const one = line<kRow>(number - 1);
  const Word* const other = line<kRow>(number + 1);
  const int place = (kRow ? from.x : from.y) + 1;
  const int bit = place % 64;
  // Bits behind the start, in the direction of the run, and the neighbours before the first bit of a word.
  Word mask = kAhead ? ~Word{1} << bit : (Word{1} << bit) - 1;
  Word one_before = 0;
  Word other_before = 0;
  int base = kAhead ? -bit : bit - 63;
  for (int at = place / 64;; kAhead ? ++at : --at, base += 64) {
    if constexpr (!kRow) columns_.prepare({from.x, std::max(64 * at - 1, 0)});
    const Word one_last = kAhead ? one[at] << 1U | one_before : one[at] >> 1U | one_before;
    const Word other_last =
        kAhead ? other[at] << 1U | other_before : other[at] >> 1U | other_before;
    const Word stop = (~here[at] | (one[at] & ~one_last) | (other[at] & ~other_last)) & mask;
    if (stop != 0) {
      const int zeros = kAhead ? std::countr_zero(stop) : std::countl_zero(stop);
      return {base + zeros, ((kAhead ? here[at] >> zeros : here[at] << zeros >> 63U) & 1U) != 0};
    }
    one_before = kAhead ? one[at] >> 63U : one[at] << 63U;
    other_before = kAhead ? other[at] >> 63U : other[at] << 63U;
    mask = ~Word{0};
  }
}

/// Visits the jump point where a run stops, if it does at one. The windows hold two cells less than usual.
template <Direction kStraight, class Visit>
[[gnu::always_inline]] inline bool JumpScan::visit_stop(Cell from, const Windows& windows,
                                                        Visit& visit) {
  constexpr bool kAhead = is_ahead(kStraight);
  ++scans_;
  const Word found = stops<kAhead>(windows);
  // There is a bit even in an empty word, far away.
  const int steps =
      kAhead ? std::countr_zero(found | Word{1} << 63U) : std::countl_zero(found | 1U);
  Stop stop{steps, ((kAhead ? windows.here >> steps : windows.here << steps >> 63U) & 1U) != 0};
  if (steps >= kWindow - 2) [[unlikely]]
    stop = scan_far<kStraight>(from);
  if (!stop.jumps) return true;
  return visit(
      ScannedJump{step(from, kStraight, stop.steps), static_cast<unsigned>(quarter(kStraight))});
}

template <Direction kStraight, class Visit>
inline bool JumpScan::shoot(Cell from, Visit& visit) {
  constexpr bool kRow = is_along_rows(kStraight);
  constexpr bool kAhead = is_ahead(kStraight);
  const int number = kRow ? from.y : from.x;
  const int at = kRow ? from.x : from.y;
  if constexpr (!kRow) columns_.prepare(from);
  const Windows windows{window<kAhead>(line<kRow>(number), at),
                        window<kAhead>(line<kRow>(number - 1), at),
                        window<kAhead>(line<kRow>(number + 1), at)};
  return visit_stop<kStraight>(from, windows, visit);
}

/// Each step moves the windows along by a cell and reads one new line of each kind.
template <Direction kDiagonal, class Visit>
bool JumpScan::sweep(Cell from, Visit& visit) {
  using enum Direction;
  constexpr Cell kStep = kDirectionSteps[static_cast<std::size_t>(kDiagonal)];
  constexpr bool kRight = kStep.x > 0;
  constexpr bool kDown = kStep.y > 0;
  constexpr bool kRowFirst = is_along_rows(turned(kDiagonal, -1));
  Cell at = from;
  columns_.prepare(at);
  Windows row{window<kRight>(line<true>(at.y), at.x), 0,
              window<kRight>(line<true>(at.y + kStep.y), at.x)};
  Windows column{window<kDown>(line<false>(at.x), at.y), 0,
                 window<kDown>(line<false>(at.x + kStep.x), at.y)};
  for (;;) {
    constexpr Word kSecond = kRight ? 2 : Word{1} << 62U;
    constexpr Word kBoth = kRight ? 3 : Word{3} << 62U;
    const bool legal = (row.here & kSecond) != 0 && (row.other & kBoth) == kBoth;
    if (!legal) return true;
    at = {at.x + kStep.x, at.y + kStep.y};
    columns_.prepare(at);
    row = {next_cells<kRight>(row.other), next_cells<kRight>(row.here),
           window<kRight>(line<true>(at.y + kStep.y), at.x)};
    column = {next_cells<kDown>(column.other), next_cells<kDown>(column.here),
              window<kDown>(line<false>(at.x + kStep.x), at.y)};
    const auto visit_row = [&] { return visit_stop<kRight ? plus_x : minus_x>(at, row, visit); };
    const auto visit_column = [&] {
      return visit_stop<kDown ? plus_y : minus_y>(at, column, visit);
    };
    if (!(kRowFirst ? visit_row() : visit_column())) return false;
    if (!(kRowFirst ? visit_column() : visit_row())) return false;
  }
}

template <class Visit>
void JumpScan::visit_jumps(Cell from, DirectionSet directions, Visit&& visit) {
  using enum Direction;
  directions &= BlockDirections::kLegal[passable_->block(from)];
  if ((directions & set_of(plus_y)) != 0 && !shoot<plus_y>(from, visit)) return;
  if ((directions & set_of(plus_x)) != 0 && !shoot<plus_x>(from, visit)) return;
  if ((directions & set_of(minus_y)) != 0 && !shoot<minus_y>(from, visit)) return;
  if ((directions & set_of(minus_x)) != 0 && !shoot<minus_x>(from, visit)) return;
  if ((directions & set_of(plus_x_plus_y)) != 0 && !sweep<plus_x_plus_y>(from, visit)) return;
  if ((directions & set_of(plus_x_minus_y)) != 0 && !sweep<plus_x_minus_y>(from, visit)) return;
  if ((directions & set_of(minus_x_minus_y)) != 0 && !sweep<minus_x_minus_y>(from, visit)) return;
  if ((directions & set_of(minus_x_plus_y)) != 0) sweep<minus_x_plus_y>(from, visit);
}

}  // namespace wend
