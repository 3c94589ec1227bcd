#include "wend/space/jump_boards.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace wend {
namespace {

constexpr unsigned kLastBit = 63;

/// A word of a line whose bits are those one place before (`at - 1`) or behind (`at + 1`).
std::uint64_t before(std::span<const std::uint64_t> words, std::size_t i) {
  return words[i] << 1U | (i > 0 ? words[i - 1] >> kLastBit : 0);
}
std::uint64_t behind(std::span<const std::uint64_t> words, std::size_t i) {
  return words[i] >> 1U | (i + 1 < words.size() ? words[i + 1] << kLastBit : 0);
}

/// The words of a board from words of another one, around each place.
template <class WordAt>
BitLines mapped(const BitLines& board, WordAt&& word_at) {
  BitLines made(board.lines(), board.length());
  for (int line = 0; line < board.lines(); ++line) {
    const auto words = made.words(line);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = word_at(line, i);
  }
  return made;
}

/// The jump points of runs along the lines, towards greater numbers (or smaller ones).
BitLines jump_points_along(const BitLines& passable, bool ahead) {
  const auto last = ahead ? before : behind;  // the cell a run comes from
  return mapped(passable, [&](int line, std::size_t i) {
    const auto here = passable.words(line);
    const auto one_side = passable.words(line - 1);
    const auto other_side = passable.words(line + 1);
    return here[i] & last(here, i) &
           ((one_side[i] & ~last(one_side, i)) | (other_side[i] & ~last(other_side, i)));
  });
}

/// Where runs stop: at jump points and where they cannot go, outside too.
BitLines with_blocked(const BitLines& jumps, const BitLines& passable) {
  return mapped(passable, [&](int line, std::size_t i) {
    return jumps.words(line)[i] | ~passable.words(line)[i];
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

/// The places from which a run reaches a jump point at its first stop. Adding a jump point to the
/// line's places without a stop carries a one through all of them up to the next stop: these are the
/// places from which a run towards smaller numbers finds it. The other way round bits are reversed.
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
      last_jump = jumping >> kLastBit;
      ray[at] = ahead ? reversed(sum ^ open) : sum ^ open;
    }
  }
  return rays;
}

/// Where the step down and to the right (or left) is legal.
BitLines legal_steps_down(const BitLines& rows, bool right) {
  const auto beside = right ? behind : before;
  return mapped(rows, [&](int line, std::size_t i) {
    const auto here = rows.words(line);
    const auto below = rows.words(line + 1);
    return here[i] & beside(here, i) & below[i] & beside(below, i);
  });
}

/// The same steps by the cells that they lead to: where the step back is legal.
BitLines legal_steps_up(const BitLines& down, bool down_right) {
  const auto from = down_right ? before : behind;
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

/// A byte for each of eight cells from a byte for each of eight boards. (H. Warren, "Hacker's
/// Delight", 7-3.)
std::uint64_t transposed_bytes(std::uint64_t bits) {
  std::uint64_t swapped = (bits ^ bits >> 7U) & 0x00AA00AA00AA00AAU;
  bits ^= swapped ^ swapped << 7U;
  swapped = (bits ^ bits >> 14U) & 0x0000CCCC0000CCCCU;
  bits ^= swapped ^ swapped << 14U;
  swapped = (bits ^ bits >> 28U) & 0x00000000F0F0F0F0U;
  return bits ^ swapped ^ swapped << 28U;
}

/// By direction: a bit of each board for every cell.
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

BitLines rows_of(const BitGrid& drawn) {
  BitLines rows(drawn.height(), drawn.width());
  for (int y = 0; y < drawn.height(); ++y) {
    const auto from = drawn.row_words(y);
    std::copy_n(from.begin(), rows.words(y).size(), rows.words(y).begin());
  }
  return rows;
}

constexpr std::size_t index(Direction direction) { return static_cast<std::size_t>(direction) / 2; }

}  // namespace

JumpBoards::JumpBoards(const BitGrid& drawn) : rows_(rows_of(drawn)), columns_(rows_.transposed()) {
  using enum Direction;
  std::array<BitLines, 4> row_rays;  // by index()
  for (const Direction direction : {down, right, up, left}) {
    const bool vertical = direction == down || direction == up;
    const bool ahead = direction == down || direction == right;
    const BitLines& passable = vertical ? columns_ : rows_;
    const BitLines jumps = jump_points_along(passable, ahead);
    BitLines& stops = stops_[index(direction)];
    stops = with_blocked(jumps, passable);
    const BitLines found = places_with_ray(jumps, stops, ahead);
    row_rays[index(direction)] = vertical ? found.transposed() : found;
  }
  const BitLines step_down_right = legal_steps_down(rows_, true);
  const BitLines step_down_left = legal_steps_down(rows_, false);
  const BitLines step_up_left = legal_steps_up(step_down_right, true);
  const BitLines step_up_right = legal_steps_up(step_down_left, false);
  const auto stops = [&](Direction one, Direction other, const BitLines& legal,
                         BitLines::Diagonals which) {
    return diagonal_stops(row_rays[index(one)], row_rays[index(other)], legal).diagonals(which);
  };
  constexpr auto kRight = BitLines::Diagonals::falling_right;
  constexpr auto kLeft = BitLines::Diagonals::falling_left;
  diagonal_stops_[index(down_right)] = stops(down, right, step_down_right, kRight);
  diagonal_stops_[index(up_right)] = stops(up, right, step_up_right, kLeft);
  diagonal_stops_[index(up_left)] = stops(up, left, step_up_left, kRight);
  diagonal_stops_[index(down_left)] = stops(down, left, step_down_left, kLeft);
  falls_right_ = step_down_right.diagonals(kRight);
  falls_left_ = step_down_left.diagonals(kLeft);
  moves_ = sets_of({&row_rays[0], &step_down_right, &row_rays[1], &step_up_right, &row_rays[2],
                    &step_up_left, &row_rays[3], &step_down_left},
                   width(), height());
}

BitLines JumpBoards::jump_points() const {
  const auto found = [](const BitLines& passable, const BitLines& one, const BitLines& other) {
    return mapped(passable, [&](int line, std::size_t i) {
      return passable.words(line)[i] & (one.words(line)[i] | other.words(line)[i]);
    });
  };
  using enum Direction;
  const BitLines by_rows = found(rows_, stops_[index(right)], stops_[index(left)]);
  const BitLines by_columns = found(columns_, stops_[index(down)], stops_[index(up)]).transposed();
  return mapped(rows_, [&](int line, std::size_t i) {
    return by_rows.words(line)[i] | by_columns.words(line)[i];
  });
}

bool JumpBoards::in_sight(Cell from, Cell to) const {
  const int right = to.x - from.x;
  const int down = to.y - from.y;
  const int diagonal = std::min(std::abs(right), std::abs(down));
  const Cell turn{from.x + (right < 0 ? -diagonal : diagonal),
                  from.y + (down < 0 ? -diagonal : diagonal)};
  const bool straight_free =
      turn.x == to.x ? columns_.all_set(to.x, std::min(turn.y, to.y), std::abs(to.y - turn.y) + 1)
                     : rows_.all_set(to.y, std::min(turn.x, to.x), std::abs(to.x - turn.x) + 1);
  if (!straight_free) return false;
  if (diagonal == 0) return true;
  const Cell top = down < 0 ? turn : from;  // steps are by the cell that they lead down from
  return (right < 0) == (down < 0)
             ? falls_right_.all_set(diagonal_line<Direction::down_right>(top), top.y, diagonal)
             : falls_left_.all_set(diagonal_line<Direction::down_left>(top), top.y, diagonal);
}

}  // namespace wend
