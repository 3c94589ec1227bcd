#include "wend/jump/jump_scan.hpp"

#include <algorithm>
#include <cstdlib>

#include "wend/space/grid/octile.hpp"

namespace wend {

bool JumpScan::sees(Cell from, Cell to) {
  const Cell bend = octile_bend(from, to);
  using enum Direction;
  // Most blocked paths are blocked in their straight part, which is read faster.
  const bool straight = bend.y == to.y  ? (bend.x <= to.x ? is_free<plus_x>(bend, to.x - bend.x)
                                                          : is_free<plus_x>(to, bend.x - to.x))
                        : bend.y < to.y ? is_free<plus_y>(bend, to.y - bend.y)
                                        : is_free<plus_y>(to, bend.y - to.y);
  return straight && diagonal_is_free(from, bend);
}

bool JumpScan::passes_jump(Cell from, Cell to) {
  using enum Direction;
  const Cell bend = octile_bend(from, to);
  if (bend.x < to.x) return scan_far<plus_x>(bend).steps < to.x - bend.x;
  if (bend.x > to.x) return scan_far<minus_x>(bend).steps < bend.x - to.x;
  if (bend.y == to.y) return false;
  columns_.prepare(bend);
  return bend.y < to.y ? scan_far<plus_y>(bend).steps < to.y - bend.y
                       : scan_far<minus_y>(bend).steps < bend.y - to.y;
}

/// Are a cell and those within `steps` steps ahead passable?
template <Direction kStraight>
bool JumpScan::is_free(Cell from, int steps) {
  constexpr bool kRow = is_along_rows(kStraight);
  ++scans_;
  const Word* const words = line<kRow>(kRow ? from.y : from.x);
  const int place = (kRow ? from.x : from.y) + 1;
  int bit = place % 64;
  int left = steps + 1;
  for (int at = place / 64; left > 0; ++at, bit = 0) {
    if constexpr (!kRow) columns_.prepare({from.x, std::max(64 * at - 1, 0)});
    const int read = std::min(left, 64 - bit);
    if ((~words[at] >> bit) << (64 - read) != 0) return false;
    left -= read;
  }
  return true;
}

bool JumpScan::diagonal_is_free(Cell from, Cell to) const {
  if (from == to) return true;
  const Direction diagonal = direction_of({to.x > from.x ? 1 : -1, to.y > from.y ? 1 : -1});
  const unsigned needed = BlockDirections::needed_by(diagonal);
  for (Cell at = from; at != to; at = step(at, diagonal)) {
    if ((passable_->block(at) & needed) != needed) return false;
  }
  return true;
}

}  // namespace wend
