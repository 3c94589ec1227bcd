#include "wend/jump/noise.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

#include "wend/map/count_bits.hpp"
#include "wend/map/word_sample.hpp"

namespace wend {
namespace {

/// A word of a row of bits, and the same bits from the cells to the left and to the right.
struct WordAround {
  std::uint64_t here;
  std::uint64_t left;
  std::uint64_t right;

  WordAround(std::span<const std::uint64_t> row, std::size_t i)
      : here(row[i]),
        left(here << 1U | (i > 0 ? row[i - 1] >> 63U : 0)),
        right(here >> 1U | (i + 1 < row.size() ? row[i + 1] << 63U : 0)) {}
};

/// The free cells beside the corner of an obstacle around which a path may turn into the open: not those of corridors
/// of one cell, which jumps follow.
std::uint64_t turns(const WordAround& above, const WordAround& here, const WordAround& below) {
  const auto along = [&](std::uint64_t from, std::uint64_t above_from, std::uint64_t below_from) {
    return from & ((above.here & ~above_from) | (below.here & ~below_from));
  };
  const auto across = [&](const WordAround& from) {
    return from.here & ((here.left & ~from.left) | (here.right & ~from.right));
  };
  const auto square = [&](const WordAround& row) {
    return row.here & ((here.left & row.left) | (here.right & row.right));
  };
  return here.here & (square(above) | square(below)) &
         (along(here.left, above.left, below.left) | along(here.right, above.right, below.right) |
          across(above) | across(below));
}

}  // namespace

bool is_noise(const BitGrid& free) {
  int blocked = 0;
  int free_cells = 0;
  int turning = 0;
  visit_sample(free, [&](int y, std::size_t i, std::uint64_t on_map) {
    const WordAround here(free.row_words(y), i);
    free_cells += count_bits(here.here);
    blocked += count_bits(on_map & ~here.here);
    if (here.here == 0) return;
    turning += count_bits(
        turns(WordAround(free.row_words(y - 1), i), here, WordAround(free.row_words(y + 1), i)));
  });
  // Turns for each blocked cell: 4 beside single ones, 1.6 in noise of 20 %, 0.4 of 40 %; 0.25 in a maze of corridors of
  // two cells, 0.2 in small rooms, 0.05 on maps of games and cities. Where they are rare, jumps are long.
  return 20 * turning > 7 * blocked && 64 * turning > free_cells;
}

}  // namespace wend
