#include "wend/render/terminal/lattice_lines.hpp"

#include <array>
#include <cstdlib>
#include <string_view>

#include "wend/geometry/direction.hpp"

namespace wend {
namespace {

constexpr unsigned bit(Direction direction) { return 1U << static_cast<unsigned>(direction); }

/// The straight directions alone, as a number from 0 to 15: 1 down, 2 right, 4 up, 8 left.
constexpr std::size_t straight(unsigned joins) {
  return (joins & 1U) | (joins >> 1U & 2U) | (joins >> 2U & 4U) | (joins >> 3U & 8U);
}

// By the straight directions.
constexpr std::array<std::string_view, 16> kLight{" ", "│", "─", "╭", "│", "│", "╰", "├",
                                                  "─", "╮", "─", "┬", "╯", "┤", "┴", "┼"};
constexpr std::array<std::string_view, 16> kDouble{" ", "║", "═", "╔", "║", "║", "╚", "╠",
                                                   "═", "╗", "═", "╦", "╝", "╣", "╩", "╬"};

std::string_view ascii_line(unsigned joins) {
  const bool across = (joins & (bit(Direction::right) | bit(Direction::left))) != 0;
  const bool down = (joins & (bit(Direction::down) | bit(Direction::up))) != 0;
  if (across && down) return "+";
  if (across) return "-";
  if (down) return "|";
  const bool falls = (joins & (bit(Direction::down_right) | bit(Direction::up_left))) != 0;
  const bool rises = (joins & (bit(Direction::up_right) | bit(Direction::down_left))) != 0;
  if (falls && rises) return "X";
  return falls ? "\\" : "/";
}

/// Every step to one of the four neighbours.
std::vector<Cell> connected(const std::vector<Cell>& way) {
  std::vector<Cell> steps;
  for (const Cell to : way) {
    if (steps.empty()) steps.push_back(to);
    while (steps.back() != to) {
      Cell next = steps.back();
      if (next.x != to.x) {
        next.x += next.x < to.x ? 1 : -1;
      } else {
        next.y += next.y < to.y ? 1 : -1;
      }
      steps.push_back(next);
    }
  }
  return steps;
}

/// Two steps around a corner become one across.
std::vector<Cell> thinned(const std::vector<Cell>& steps) {
  std::vector<Cell> thin;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool ends = thin.empty() || i + 1 == steps.size();
    const bool turns = !ends && std::abs(steps[i + 1].x - thin.back().x) == 1 &&
                       std::abs(steps[i + 1].y - thin.back().y) == 1;
    if (!turns) thin.push_back(steps[i]);
  }
  return thin;
}

}  // namespace

void LatticeLines::add(const std::vector<Cell>& way, bool reverse) {
  std::vector<Cell> steps = connected(way);
  if (ascii_) steps = thinned(steps);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    join(steps[i - 1], steps[i], reverse);
    join(steps[i], steps[i - 1], reverse);
  }
}

void LatticeLines::join(Cell from, Cell to, bool reverse) {
  if (!joins_.contains(from) || !joins_.contains(to)) return;
  Joins& joins = joins_[from];
  std::uint8_t& way = reverse ? joins.reverse : joins.ahead;
  way = static_cast<std::uint8_t>(way | bit(nearest_direction(from, to, false)));
}

std::optional<Glyph> LatticeLines::operator[](Cell character) const {
  const Joins& joins = joins_[character];
  const unsigned all = joins.ahead | joins.reverse;
  if (all == 0) return std::nullopt;
  if (joins.reverse != 0) {  // the rarer one shows where both drive
    return Glyph{ascii_ ? "=" : kDouble[straight(all)], Meaning::reverse};
  }
  return Glyph{ascii_ ? ascii_line(all) : kLight[straight(all)], Meaning::ahead};
}

}  // namespace wend
