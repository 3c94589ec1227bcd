#pragma once

// JumpGraph: the jump points of a map, and from each of them the ones that come next, found when they
// are first asked for and kept.
//
// A jump point is left straight on in the direction it was reached in, and past the obstacles beside
// it. What comes next does not depend on where a search began, so a graph is worth more with every
// search on it. Between a jump point and the next one a path takes its diagonal steps first, so its
// length is the octile distance of the two.
//
//   wend::JumpGraph graph(boards);
//   for (const wend::Jump jump : graph.jumps(number, arrivals)) reach(jump.number(), jump.arrival());
//
// Jump points are numbered tile by tile, so that near ones lie near each other in memory. 12 bytes
// for 64 cells, 25 a jump point, and 4 a jump that was found. One thread.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/space/jump_boards.hpp"

namespace wend {

/// To which jump point, and in which straight direction it is reached.
class Jump {
 public:
  Jump() = default;
  explicit Jump(std::uint32_t code) : code_(code) {}
  Jump(std::uint32_t number, unsigned arrival) : code_(number << 2U | arrival) {}

  std::uint32_t number() const { return code_ >> 2U; }
  /// 0 to 3 for down, right, up and left.
  unsigned arrival() const { return code_ & 3U; }
  std::uint32_t code() const { return code_; }

 private:
  std::uint32_t code_ = 0;
};

constexpr unsigned kArrivals = 4;

class JumpGraph {
 public:
  explicit JumpGraph(std::shared_ptr<const JumpBoards> boards);

  const JumpBoards& boards() const { return *boards_; }

  /// How many jump points there are.
  std::size_t size() const { return cells_.size(); }
  Cell cell(std::uint32_t number) const { return cells_[number]; }

  /// The directions in which a jump point is left that was reached so: straight on, and past the
  /// obstacles beside it.
  DirectionSet directions(std::uint32_t number, unsigned arrival) const {
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
    return kLeaving[arrival][forced_[number] >> (2 * arrival) & 3U];
  }

  /// What comes next. Holds until the next call.
  std::span<const Jump> jumps(std::uint32_t number, unsigned arrival) {
    std::uint32_t& list = lists_[kArrivals * number + arrival];
    if (list == kUnknown) list = find(number, arrival);
    return {jumps_.data() + list + 1, jumps_[list].code()};
  }

  /// Appends what comes next from any cell in these directions.
  void append_jumps(Cell from, DirectionSet directions, std::vector<Jump>& jumps) const;

 private:
  static constexpr std::uint32_t kUnknown = static_cast<std::uint32_t>(-1);

  void number_word(int y, std::size_t word);
  std::uint32_t number_of(Cell cell) const;
  std::uint32_t find(std::uint32_t number, unsigned arrival);
  std::uint8_t forced_at(Cell cell) const;

  template <Direction kStraight>
  void shoot(Cell from, std::vector<Jump>& jumps) const;
  template <Direction kDiagonal>
  void sweep(Cell from, std::vector<Jump>& jumps) const;

  std::shared_ptr<const JumpBoards> boards_;
  BitLines board_;  // the jump points, by rows
  std::vector<std::uint32_t>
      before_;                        // by word of the board: what its first jump point's number is
  std::vector<Cell> cells_;           // by number
  std::vector<std::uint8_t> forced_;  // by number: two bits for each arrival
  std::vector<std::uint32_t> lists_;  // by number and arrival: where its jumps begin
  std::vector<Jump> jumps_;           // lists, each behind its length
};

}  // namespace wend
