#pragma once

// JumpGraph: the numbered jump points of a map and the successors of each of them.
//
// A path leaves a jump point straight on, in the direction of its arrival, and past the obstacles beside
// it. The successors do not depend on where the path began. Between a jump point and its successor a path
// takes its diagonal steps first, so its length is the octile distance of the two.
//
//   const wend::JumpGraph graph(boards);
//   graph.append_jumps(graph.cell(jump.number()), graph.directions(jump), jumps);
//
// Jump points are numbered tile by tile, so that near ones lie near each other in memory. 12 bytes per 64 cells
// and 9 per jump point; at most 2^29 jump points.
//
// After an edit of the map, repair() numbers the new jump points behind all others. The others keep their numbers,
// and the number of one that is gone waits for its cell to become one again.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/jump/jump_boards.hpp"

namespace wend {

/// A jump: the jump point that it reaches, and the straight direction in which it arrives.
class Jump {
 public:
  Jump() = default;
  constexpr explicit Jump(std::uint32_t code) : code_(code) {}
  constexpr Jump(std::uint32_t number, unsigned arrival) : code_(number << 2U | arrival) {}

  constexpr std::uint32_t number() const { return code_ >> 2U; }
  /// 0 to 3 for +y, +x, -y and -x.
  constexpr unsigned arrival() const { return code_ & 3U; }
  /// Both in one number, below 2^31.
  constexpr std::uint32_t code() const { return code_; }

  friend bool operator==(Jump, Jump) = default;

 private:
  std::uint32_t code_ = 0;
};

constexpr unsigned kArrivals = 4;

class JumpGraph {
 public:
  explicit JumpGraph(std::shared_ptr<const JumpBoards> boards);

  const JumpBoards& boards() const { return *boards_; }

  /// The number of numbers: of jump points, and of cells that were some before an edit.
  std::size_t size() const { return cells_.size(); }
  Cell cell(std::uint32_t number) const { return cells_[number]; }

  /// The directions in which a path leaves the jump point after this arrival: straight on, and past the
  /// obstacles beside it.
  DirectionSet directions(Jump jump) const {
    // Bit 0 of `forced`: past the obstacle on the counter-clockwise side, bit 1 on the other.
    constexpr auto kLeaving = [] {
      std::array<std::array<DirectionSet, 4>, kArrivals> sets{};
      for (unsigned from = 0; from < kArrivals; ++from) {
        const auto ahead = static_cast<Direction>(2 * from);
        for (unsigned forced = 0; forced < 4; ++forced) {
          unsigned set = set_of(ahead);
          if ((forced & 1U) != 0) set |= set_of(turned(ahead, 1)) | set_of(turned(ahead, 2));
          if ((forced & 2U) != 0) set |= set_of(turned(ahead, -1)) | set_of(turned(ahead, -2));
          sets[from][forced] = static_cast<DirectionSet>(set);
        }
      }
      return sets;
    }();
    return kLeaving[jump.arrival()][forced_[jump.number()] >> (2 * jump.arrival()) & 3U];
  }

  bool is_jump_point(Cell cell) const { return board_.get(cell.y, cell.x); }
  /// The number of a jump point.
  std::uint32_t number_of(Cell cell) const;

  /// Room for this many numbers saves copies of all others after an edit.
  std::size_t size_after_edits() const { return size() + size() / 64 + 256; }

  /// Follows boards() after JumpBoards::repair() with these boxes. O(cells of the boxes).
  void repair(std::span<const CellBox> boxes);

  /// Calls visit(jump) for the next jump points from any cell in these directions, until it returns
  /// false.
  template <class Visit>
  void visit_jumps(Cell from, DirectionSet directions, Visit&& visit) const;

  void append_jumps(Cell from, DirectionSet directions, std::vector<Jump>& jumps) const {
    visit_jumps(from, directions, [&](Jump jump) {
      jumps.push_back(jump);
      return true;
    });
  }

 private:
  /// The numbers of the places of a word that has been repaired; kNone where there has been no jump point.
  using Patch = std::array<std::uint32_t, 64>;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  static constexpr std::uint32_t kPatched = std::uint32_t{1} << 31U;

  void number_word(int y, std::size_t word);
  Patch& patch_of(Cell cell);
  std::uint8_t forced_at(Cell cell) const;

  template <Direction kStraight>
  Jump shoot(Cell from) const;
  template <Direction kDiagonal, class Visit>
  bool sweep(Cell from, Visit& visit) const;

  std::shared_ptr<const JumpBoards> boards_;
  BitLines board_;  // the jump points, by rows
  std::vector<std::uint32_t>
      before_;  // by word of the board: the number of its first jump point, or its patch
  std::vector<Patch> patches_;
  std::vector<Cell> cells_;           // by number
  std::vector<std::uint8_t> forced_;  // by number: two bits for each arrival
};

inline std::uint32_t JumpGraph::number_of(Cell cell) const {
  constexpr std::size_t kWordBits = 64;
  const auto words = board_.words(cell.y);
  const auto bit = static_cast<std::size_t>(cell.x + 1);
  const std::uint64_t below = (std::uint64_t{1} << (bit % kWordBits)) - 1;
  const std::size_t word = bit / kWordBits;
  const std::uint32_t before = before_[static_cast<std::size_t>(cell.y) * words.size() + word];
  if ((before & kPatched) != 0) [[unlikely]]
    return patches_[before & ~kPatched][bit % kWordBits];
  return before + static_cast<std::uint32_t>(std::popcount(words[word] & below));
}

template <Direction kStraight>
Jump JumpGraph::shoot(Cell from) const {
  const Cell stop = step(from, kStraight, boards_->distance_to_stop<kStraight>(from));
  return {number_of(stop), static_cast<unsigned>(quarter(kStraight))};
}

/// A diagonal run casts straight runs along its way; a search need not stop where the path turns.
template <Direction kDiagonal, class Visit>
bool JumpGraph::sweep(Cell from, Visit& visit) const {
  constexpr Direction kOne = turned(kDiagonal, -1);
  constexpr Direction kOther = turned(kDiagonal, 1);
  Cell at = from;
  DirectionSet moves = 0;
  do {
    at = step(at, kDiagonal, boards_->distance_to_stop<kDiagonal>(at));
    moves = boards_->moves(at);
    if ((moves & set_of(kOne)) != 0 && !visit(shoot<kOne>(at))) return false;
    if ((moves & set_of(kOther)) != 0 && !visit(shoot<kOther>(at))) return false;
  } while ((moves & set_of(kDiagonal)) != 0);
  return true;
}

template <class Visit>
void JumpGraph::visit_jumps(Cell from, DirectionSet directions, Visit&& visit) const {
  using enum Direction;
  directions &= boards_->moves(from);
  if ((directions & set_of(plus_y)) != 0 && !visit(shoot<plus_y>(from))) return;
  if ((directions & set_of(plus_x)) != 0 && !visit(shoot<plus_x>(from))) return;
  if ((directions & set_of(minus_y)) != 0 && !visit(shoot<minus_y>(from))) return;
  if ((directions & set_of(minus_x)) != 0 && !visit(shoot<minus_x>(from))) return;
  if ((directions & set_of(plus_x_plus_y)) != 0 && !sweep<plus_x_plus_y>(from, visit)) return;
  if ((directions & set_of(plus_x_minus_y)) != 0 && !sweep<plus_x_minus_y>(from, visit)) return;
  if ((directions & set_of(minus_x_minus_y)) != 0 && !sweep<minus_x_minus_y>(from, visit)) return;
  if ((directions & set_of(minus_x_plus_y)) != 0) sweep<minus_x_plus_y>(from, visit);
}

}  // namespace wend
