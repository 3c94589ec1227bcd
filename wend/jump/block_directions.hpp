#pragma once

// BlockDirections: what the 3 x 3 cells around a cell (BitGrid::block()) say of the directions in which a path goes on
// from it, as tables.

#include <array>
#include <cstddef>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"

namespace wend {

class BlockDirections {
 public:
  static constexpr std::size_t kBlocks = 512;
  using Table = std::array<DirectionSet, kBlocks>;

  /// The cells of a block that a diagonal step needs.
  static constexpr unsigned needed_by(Direction diagonal) {
    return bit_of(diagonal) | bit_of(turned(diagonal, -1)) | bit_of(turned(diagonal, 1));
  }

  /// The directions in which a step is legal.
  static const Table kLegal;

  /// The directions in which a path leaves a jump point, by its arrival (0 to 3 for +y, +x, -y and -x): straight on,
  /// and past the obstacles beside it.
  static const std::array<Table, 4> kLeaving;

 private:
  /// The bit of a neighbour in a block.
  static constexpr unsigned bit_of(Direction direction) {
    const Cell way = kDirectionSteps[static_cast<std::size_t>(direction)];
    return 1U << static_cast<unsigned>(3 * (1 - way.y) + 1 + way.x);
  }

  static constexpr Table make_legal() {
    Table table{};
    for (unsigned block = 0; block < kBlocks; ++block) {
      unsigned set = 0;
      for (unsigned i = 0; i < kDirections; ++i) {
        const auto direction = static_cast<Direction>(i);
        const unsigned needed = is_diagonal(direction) ? needed_by(direction) : bit_of(direction);
        if ((block & needed) == needed) set |= set_of(direction);
      }
      table[block] = static_cast<DirectionSet>(set);
    }
    return table;
  }

  static constexpr Table make_leaving(Direction ahead) {
    Table table{};
    for (unsigned block = 0; block < kBlocks; ++block) {
      const auto free = [block](Direction at) { return (block & bit_of(at)) != 0; };
      unsigned set = set_of(ahead);
      for (const int side : {1, -1}) {
        const bool forced = free(opposite(ahead)) && free(turned(ahead, 2 * side)) &&
                            !free(turned(ahead, 3 * side));
        if (forced) set |= set_of(turned(ahead, side)) | set_of(turned(ahead, 2 * side));
      }
      table[block] = static_cast<DirectionSet>(set);
    }
    return table;
  }
};

inline constexpr BlockDirections::Table BlockDirections::kLegal = BlockDirections::make_legal();

inline constexpr std::array<BlockDirections::Table, 4> BlockDirections::kLeaving{
    BlockDirections::make_leaving(Direction::plus_y),
    BlockDirections::make_leaving(Direction::plus_x),
    BlockDirections::make_leaving(Direction::minus_y),
    BlockDirections::make_leaving(Direction::minus_x)};

}  // namespace wend
