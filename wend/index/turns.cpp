#include "wend/index/turns.hpp"

#include <bit>
#include <cstdlib>

namespace wend {
namespace {

constexpr unsigned compute_turn_sides(unsigned block) {
  const auto passable = [block](Cell at) { return (block >> (4 - 3 * at.y + at.x) & 1U) != 0; };
  unsigned sides = 0;
  for (unsigned straight = 0; straight < 4; ++straight) {
    const Cell ahead = kDrawnSteps[2 * straight];
    if (!passable({-ahead.x, -ahead.y})) continue;
    for (const unsigned turn : {1U, 3U}) {
      const Cell beside = kDrawnSteps[(2 * (straight + turn)) % kDirections];
      if (!passable(beside) || passable({beside.x - ahead.x, beside.y - ahead.y})) continue;
      sides |= (turn == 1 ? 1U : 2U) << (2 * straight);
    }
  }
  return sides;
}

constexpr auto kTurnSides = [] {
  std::array<std::uint8_t, 512> table{};
  for (unsigned block = 0; block < table.size(); ++block) {
    table[block] = static_cast<std::uint8_t>(compute_turn_sides(block));
  }
  return table;
}();

/// One bit a straight direction, where a pair of sides is not empty: at bits 0, 2, 4, 6.
constexpr unsigned turning_straights(unsigned sides) { return (sides | sides >> 1U) & 0x55U; }

}  // namespace

unsigned turn_sides(unsigned block) { return kTurnSides[block]; }

Turns::Turns(const BitGrid& passable)
    : corners_(passable), rays_(passable, Rays::Stops::jump_points) {
  first_.reserve(corners_.size());
  for (std::uint32_t corner = 0; corner < corners_.size(); ++corner) {
    const Cell cell = corners_.cell(corner);
    first_.push_back(size());
    const unsigned straights = turning_straights(sides(cell));
    for (Straight straight = 0; straight < 4; ++straight) {
      if ((straights >> (2 * straight) & 1U) == 0) continue;
      cells_.push_back(cell);
      straights_.push_back(static_cast<std::uint8_t>(straight));
    }
  }
}

std::uint32_t Turns::number(Cell cell, unsigned sides, Straight straight) const {
  const unsigned before = turning_straights(sides) & ((1U << (2 * straight)) - 1);
  return first_[corners_.number(cell)] + static_cast<std::uint32_t>(std::popcount(before));
}

bool Turns::sees(Cell from, Cell to) const {
  while (from != to) {
    const Cell step{(to.x > from.x) - (to.x < from.x), (to.y > from.y) - (to.y < from.y)};
    const Cell next{from.x + step.x, from.y + step.y};
    if (!passable()[{next.x, from.y}] || !passable()[{from.x, next.y}] || !passable()[next]) {
      return false;
    }
    from = next;
  }
  return true;
}

}  // namespace wend
