#include "wend/space/grid/ordered_grid.hpp"

namespace wend {
namespace {

/// On a page, where y grows downwards.
Direction on_page_of(char letter) {
  switch (letter) {
    case 'u':
      return Direction::minus_y;
    case 'd':
      return Direction::plus_y;
    case 'l':
      return Direction::minus_x;
    default:
      return Direction::plus_x;
  }
}

std::string_view letters_of(NeighbourOrder order) {
  for (const auto& choice : choice_names(order)) {
    if (choice.value == order) return choice.name;
  }
  return {};
}

}  // namespace

std::array<Direction, kDirections> directions_in(NeighbourOrder order, const Frame& frame) {
  std::array<Direction, kDirections> directions{};
  for (std::size_t i = 0; i < directions.size(); ++i) directions[i] = static_cast<Direction>(i);
  if (order == NeighbourOrder::any) return directions;
  std::array<int, kDirections> rank{};
  int next = 0;
  for (const char letter : letters_of(order)) {
    rank[static_cast<std::size_t>(on_page(on_page_of(letter), frame))] = next++;
  }
  for (const Direction diagonal : kDiagonalDirections) {
    const auto [one, other] = beside(diagonal);
    const int first = rank[static_cast<std::size_t>(one)];
    const int second = rank[static_cast<std::size_t>(other)];
    // Behind the straight ones, by the better of the two beside it, then by the other.
    rank[static_cast<std::size_t>(diagonal)] =
        kDirections * (1 + std::min(first, second)) + std::max(first, second);
  }
  std::ranges::sort(directions, {},
                    [&](Direction direction) { return rank[static_cast<std::size_t>(direction)]; });
  return directions;
}

}  // namespace wend
