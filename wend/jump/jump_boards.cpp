#include "wend/jump/jump_boards.hpp"

#include <algorithm>
#include <cstdlib>

#include "wend/space/grid/octile.hpp"

namespace wend {
namespace {

using enum BitLines::Diagonals;

/// The jump points of runs along the lines, towards greater numbers (or smaller ones).
BitLines jump_points_along(const BitLines& passable, bool ahead) {
  const auto last = ahead ? bits_before : bits_behind;  // the cell a run comes from
  return mapped(passable, [&](int line, std::size_t i) {
    const auto here = passable.words(line);
    const auto one_side = passable.words(line - 1);
    const auto other_side = passable.words(line + 1);
    return here[i] & last(here, i) &
           ((one_side[i] & ~last(one_side, i)) | (other_side[i] & ~last(other_side, i)));
  });
}

std::uint64_t reversed(std::uint64_t word) {
  constexpr std::uint64_t kEverySecond = 0x5555555555555555U;
  constexpr std::uint64_t kPairs = 0x3333333333333333U;
  constexpr std::uint64_t kNibbles = 0x0F0F0F0F0F0F0F0FU;
  word = (word >> 1U & kEverySecond) | (word & kEverySecond) << 1U;
  word = (word >> 2U & kPairs) | (word & kPairs) << 2U;
  word = (word >> 4U & kNibbles) | (word & kNibbles) << 4U;
  return __builtin_bswap64(word);
}

/// The places from which a run reaches a jump point at its first stop. Adding a jump point to the line's
/// places without a stop carries a one through all of them up to the next stop: these are the places
/// from which a run towards smaller numbers finds it. For the other direction the bits are reversed.
BitLines places_with_ray(const BitLines& jumps, const BitLines& stops, bool ahead) {
  BitLines rays(jumps.lines(), jumps.length());
  for (int line = 0; line < jumps.lines(); ++line) {
    const auto jump = jumps.words(line);
    const auto stop = stops.words(line);
    const auto ray = rays.words(line);
    std::uint64_t carry = 0;
    std::uint64_t last_jump = 0;  // the highest bit of the word before
    for (std::size_t i = 0; i < ray.size(); ++i) {
      const std::size_t at = ahead ? ray.size() - 1 - i : i;
      const std::uint64_t jumping = ahead ? reversed(jump[at]) : jump[at];
      const std::uint64_t open = ahead ? ~reversed(stop[at]) : ~stop[at];
      const std::uint64_t first = open + (jumping << 1U | last_jump);
      const std::uint64_t sum = first + carry;
      carry = (first < open ? 1U : 0U) | (sum < first ? 1U : 0U);
      last_jump = jumping >> 63U;
      ray[at] = ahead ? reversed(sum ^ open) : sum ^ open;
    }
  }
  return rays;
}

/// Where the step down and to the right (or left) is legal.
BitLines legal_steps_down(const BitLines& rows, bool right) {
  const auto next_to = right ? bits_behind : bits_before;
  return mapped(rows, [&](int line, std::size_t i) {
    const auto here = rows.words(line);
    const auto below = rows.words(line + 1);
    return here[i] & next_to(here, i) & below[i] & next_to(below, i);
  });
}

/// The same steps by the cells that they lead to: where the step back is legal.
BitLines legal_steps_up(const BitLines& down, bool down_right) {
  const auto from = down_right ? bits_before : bits_behind;
  return mapped(down, [&](int line, std::size_t i) { return from(down.words(line - 1), i); });
}

/// Where a diagonal run stops: at a ray of either direction, and where no step is legal.
BitLines diagonal_stops(const BitLines& one, const BitLines& other, const BitLines& legal) {
  return mapped(legal, [&](int line, std::size_t i) {
    return one.words(line)[i] | other.words(line)[i] | ~legal.words(line)[i];
  });
}

/// Eight bits of a line, from a place that is a multiple of eight.
std::uint64_t eight_bits(const BitLines& board, int line, int at) {
  const auto words = board.words(line);
  const auto bit = static_cast<std::size_t>(at + 1);
  std::uint64_t bits = words[bit / 64] >> (bit % 64);
  if (bit % 64 > 56 && bit / 64 + 1 < words.size()) bits |= words[bit / 64 + 1] << (64 - bit % 64);
  return bits & 0xFFU;
}

/// Transposes one byte per board, for eight boards, into one byte per cell, for eight cells. (H. Warren,
/// "Hacker's Delight", 7-3.)
std::uint64_t transposed_bytes(std::uint64_t bits) {
  std::uint64_t swapped = (bits ^ bits >> 7U) & 0x00AA00AA00AA00AAU;
  bits ^= swapped ^ swapped << 7U;
  swapped = (bits ^ bits >> 14U) & 0x0000CCCC0000CCCCU;
  bits ^= swapped ^ swapped << 14U;
  swapped = (bits ^ bits >> 28U) & 0x00000000F0F0F0F0U;
  return bits ^ swapped ^ swapped << 28U;
}

/// For each cell, the set of directions whose board has its bit.
Grid<DirectionSet> sets_of(const std::array<const BitLines*, kDirections>& boards, int width,
                           int height) {
  Grid<DirectionSet> sets(width, height);
  for (int y = 0; y < height; ++y) {
    const auto row = sets.row(y);
    for (int x = 0; x < width; x += kDirections) {
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < boards.size(); ++i) {
        bits |= eight_bits(*boards[i], y, x) << (8 * i);
      }
      bits = transposed_bytes(bits);
      const int count = std::min(kDirections, width - x);
      for (int i = 0; i < count; ++i) {
        row[static_cast<std::size_t>(x + i)] = static_cast<DirectionSet>(bits >> (8 * i));
      }
    }
  }
  return sets;
}

}  // namespace

Sight::Sight(const BitGrid& passable) : rows_(passable), columns_(rows_.transposed()) {
  const BitLines squares = legal_steps_down(rows_, true);
  falling_right_ = squares.diagonals(falling_right);
  falling_left_ = squares.diagonals(falling_left);
}

bool Sight::sees(Cell from, Cell to) const {
  const Cell bend = octile_bend(from, to);
  // Most blocked paths are blocked in their straight part, which is read faster.
  return straight_is_free(bend, to) && diagonal_is_free(from, bend);
}

bool Sight::diagonal_is_free(Cell from, Cell to) const {
  if (from == to) return true;
  const int steps = std::abs(to.y - from.y);
  const Cell top = from.y < to.y ? from : to;
  if ((to.x > from.x) == (to.y > from.y)) {
    return falling_right_.all_set(diagonal_line(falling_right, top, rows_.lines()), top.y, steps);
  }
  const Cell square{top.x - 1, top.y};  // of its first step
  return falling_left_.all_set(diagonal_line(falling_left, square, rows_.lines()), top.y, steps);
}

bool Sight::straight_is_free(Cell from, Cell to) const {
  return from.x == to.x
             ? columns_.all_set(from.x, std::min(from.y, to.y), std::abs(to.y - from.y) + 1)
             : rows_.all_set(from.y, std::min(from.x, to.x), std::abs(to.x - from.x) + 1);
}

JumpBoards::JumpBoards(const BitGrid& passable) : sight_(passable) {
  using enum Direction;
  std::array<BitLines, 4> row_rays;  // by quarter()
  for (const Direction direction : kStraightDirections) {
    const bool vertical = direction == plus_y || direction == minus_y;
    const bool ahead = direction == plus_y || direction == plus_x;
    const BitLines& lines = vertical ? sight_.columns() : rows();
    const BitLines jumps = jump_points_along(lines, ahead);
    BitLines& stops = stops_[static_cast<std::size_t>(direction)];
    stops = with_blocked(jumps, lines);
    const BitLines found = places_with_ray(jumps, stops, ahead);
    row_rays[quarter(direction)] = vertical ? found.transposed() : found;
  }
  const BitLines step_down_right = legal_steps_down(rows(), true);
  const BitLines step_down_left = legal_steps_down(rows(), false);
  const BitLines step_up_left = legal_steps_up(step_down_right, true);
  const BitLines step_up_right = legal_steps_up(step_down_left, false);
  const std::array<const BitLines*, 4> legal{&step_down_right, &step_up_right, &step_up_left,
                                             &step_down_left};  // by quarter()
  std::array<const BitLines*, kDirections> boards{};
  for (const Direction direction : kDiagonalDirections) {
    const auto [one, other] = beside(direction);
    stops_[static_cast<std::size_t>(direction)] =
        diagonal_stops(row_rays[quarter(one)], row_rays[quarter(other)], *legal[quarter(direction)])
            .diagonals(diagonals_along(direction));
    boards[static_cast<std::size_t>(direction)] = legal[quarter(direction)];
  }
  for (const Direction direction : kStraightDirections) {
    boards[static_cast<std::size_t>(direction)] = &row_rays[quarter(direction)];
  }
  moves_ = sets_of(boards, width(), height());
}

bool JumpBoards::passes_jump(Cell from, Cell to) const {
  using enum Direction;
  const Cell bend = octile_bend(from, to);
  if (bend.x < to.x) return distance_to_stop<plus_x>(bend) < to.x - bend.x;
  if (bend.x > to.x) return distance_to_stop<minus_x>(bend) < bend.x - to.x;
  if (bend.y < to.y) return distance_to_stop<plus_y>(bend) < to.y - bend.y;
  return bend.y > to.y && distance_to_stop<minus_y>(bend) < bend.y - to.y;
}

BitLines JumpBoards::jump_points() const {
  const auto found = [](const BitLines& passable, const BitLines& one, const BitLines& other) {
    return mapped(passable, [&](int line, std::size_t i) {
      return passable.words(line)[i] & (one.words(line)[i] | other.words(line)[i]);
    });
  };
  const auto stops = [this](Direction direction) -> const BitLines& {
    return stops_[static_cast<std::size_t>(direction)];
  };
  using enum Direction;
  const BitLines by_rows = found(rows(), stops(plus_x), stops(minus_x));
  const BitLines by_columns = found(sight_.columns(), stops(plus_y), stops(minus_y)).transposed();
  return mapped(rows(), [&](int line, std::size_t i) {
    return by_rows.words(line)[i] | by_columns.words(line)[i];
  });
}

}  // namespace wend
