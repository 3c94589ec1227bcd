#pragma once

// JumpScan: finds jump points on the cells of a map, without anything prepared.
//
// A straight scan compares the words of three neighbouring lines of cells: a run stops at a blocked cell, or
// beside a free cell that a blocked one comes before, which makes it a jump point (jump_boards.hpp). It reads
// up to 64 cells at a time. A diagonal run goes step by step and scans to both sides. JumpGraph on JumpBoards
// finds the same jumps, in the same order, faster, but first reads the whole map.
//
//   wend::JumpScan scan(space.passable());
//   scan.visit_jumps(cell, 0xFF, [&](const wend::ScannedJump& jump) { return use(jump); });
//
// One thread.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
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
    return kLeaving[jump.arrival][passable_->block(jump.cell)];
  }

  /// Calls visit(jump) for the next jump points from a cell in these directions, until it returns false.
  template <class Visit>
  void visit_jumps(Cell from, DirectionSet directions, Visit&& visit);

  /// Is the path between two cells that takes its diagonal steps first, then its straight steps, free? As
  /// Sight::sees().
  bool sees(Cell from, Cell to);

  /// The number of scans so far: a measure of the time spent.
  std::uint64_t scans() const { return scans_; }

 private:
  /// Where a run stops.
  struct Stop {
    int steps;
    bool jumps;  // at a jump point, else before a blocked cell
  };

  template <Direction kStraight>
  Stop scan(Cell from);
  template <Direction kDiagonal, class Visit>
  bool sweep(Cell from, Visit& visit);
  template <Direction kStraight, class Visit>
  bool shoot(Cell from, Visit& visit);
  template <Direction kStraight>
  bool is_free(Cell from, int steps);
  bool diagonal_is_free(Cell from, Cell to) const;

  /// The bit of a neighbour in BitGrid::block().
  static constexpr unsigned block_bit(Direction direction) {
    const Cell way = kDirectionSteps[static_cast<std::size_t>(direction)];
    return 1U << static_cast<unsigned>(3 * (1 - way.y) + 1 + way.x);
  }
  /// The cells of a block that a diagonal step needs.
  static constexpr unsigned needs(Direction diagonal) {
    return block_bit(diagonal) | block_bit(turned(diagonal, -1)) | block_bit(turned(diagonal, 1));
  }

  static constexpr std::size_t kBlocks = 512;
  static constexpr std::size_t kArrivalCount = 4;
  using LeavingTable = std::array<std::array<DirectionSet, kBlocks>, kArrivalCount>;
  static constexpr LeavingTable make_leaving();
  static const LeavingTable kLeaving;

  const BitGrid* passable_;
  const std::uint64_t* rows_;  // of row 0
  std::ptrdiff_t row_words_;
  ColumnTiles columns_;
  std::uint64_t scans_ = 0;
};

constexpr JumpScan::LeavingTable JumpScan::make_leaving() {
  LeavingTable table{};
  for (unsigned arrival = 0; arrival < kArrivalCount; ++arrival) {
    const auto ahead = static_cast<Direction>(2 * arrival);
    for (unsigned block = 0; block < kBlocks; ++block) {
      const auto free = [block](Direction at) { return (block & block_bit(at)) != 0; };
      unsigned set = set_of(ahead);
      for (const int side : {1, -1}) {
        const bool forced = free(opposite(ahead)) && free(turned(ahead, 2 * side)) &&
                            !free(turned(ahead, 3 * side));
        if (forced) set |= set_of(turned(ahead, side)) | set_of(turned(ahead, 2 * side));
      }
      table[arrival][block] = static_cast<DirectionSet>(set);
    }
  }
  return table;
}

inline constexpr JumpScan::LeavingTable JumpScan::kLeaving = JumpScan::make_leaving();

template <Direction kStraight>
JumpScan::Stop JumpScan::scan(Cell from) {
  using enum Direction;
  constexpr bool kRow = kStraight == plus_x || kStraight == minus_x;
  constexpr bool kAhead = kStraight == plus_x || kStraight == plus_y;
  ++scans_;
  const auto place = static_cast<std::size_t>((kRow ? from.x : from.y) + 1);
  std::size_t at = place / 64;
  const auto bit = static_cast<int>(place % 64);
  std::ptrdiff_t next = kRow ? 1 : ColumnTiles::kDown;
  if (!kAhead) next = -next;
  if constexpr (!kRow) columns_.prepare(from.x, at);
  const std::uint64_t* here = nullptr;
  const std::uint64_t* one = nullptr;
  const std::uint64_t* other = nullptr;
  if constexpr (kRow) {
    here = rows_ + from.y * row_words_ + static_cast<std::ptrdiff_t>(at);
    one = here - row_words_;
    other = here + row_words_;
  } else {
    here = columns_.word(from.x, at);
    one = columns_.word(from.x - 1, at);
    other = columns_.word(from.x + 1, at);
  }
  // Bits behind the start, in the direction of the run, and the neighbours before the first bit of a word.
  std::uint64_t mask = kAhead ? ~std::uint64_t{1} << bit : (std::uint64_t{1} << bit) - 1;
  std::uint64_t one_before = 0;
  std::uint64_t other_before = 0;
  int base = kAhead ? -bit : bit - 63;
  for (;;) {
    const std::uint64_t one_last = kAhead ? *one << 1U | one_before : *one >> 1U | one_before;
    const std::uint64_t other_last =
        kAhead ? *other << 1U | other_before : *other >> 1U | other_before;
    const std::uint64_t stop = (~*here | (*one & ~one_last) | (*other & ~other_last)) & mask;
    if (stop != 0) {
      const int zeros = kAhead ? std::countr_zero(stop) : std::countl_zero(stop);
      const std::uint64_t found = kAhead ? *here >> zeros : *here << zeros >> 63U;
      return {base + zeros, (found & 1U) != 0};
    }
    one_before = kAhead ? *one >> 63U : *one << 63U;
    other_before = kAhead ? *other >> 63U : *other << 63U;
    mask = ~std::uint64_t{0};
    base += 64;
    here += next;
    one += next;
    other += next;
    if constexpr (!kRow) columns_.prepare(from.x, kAhead ? ++at : --at);
  }
}

template <Direction kStraight, class Visit>
bool JumpScan::shoot(Cell from, Visit& visit) {
  const Stop stop = scan<kStraight>(from);
  if (!stop.jumps) return true;
  return visit(ScannedJump{step(from, kStraight, stop.steps),
                           static_cast<unsigned>(quarter(kStraight))});
}

template <Direction kDiagonal, class Visit>
bool JumpScan::sweep(Cell from, Visit& visit) {
  constexpr unsigned kNeeds = needs(kDiagonal);
  for (Cell at = from; (passable_->block(at) & kNeeds) == kNeeds;) {
    at = step(at, kDiagonal);
    if (!shoot<turned(kDiagonal, -1)>(at, visit)) return false;
    if (!shoot<turned(kDiagonal, 1)>(at, visit)) return false;
  }
  return true;
}

template <class Visit>
void JumpScan::visit_jumps(Cell from, DirectionSet directions, Visit&& visit) {
  using enum Direction;
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
