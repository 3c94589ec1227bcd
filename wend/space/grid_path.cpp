#include "wend/space/grid_path.hpp"

#include <numbers>

#include "wend/space/grid_space.hpp"

namespace wend {
namespace {

std::string text_of(Cell cell) {
  return '(' + std::to_string(cell.x) + ',' + std::to_string(cell.y) + ')';
}

bool is_diagonal_step(Cell from, Cell to) { return from.x != to.x && from.y != to.y; }

}  // namespace

double grid_path_cost(const FreeSpace& space, std::span<const Cell> cells) {
  double terrain_cost = 0;
  double diagonals = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const bool diagonal = is_diagonal_step(cells[i - 1], cells[i]);
    diagonals += diagonal ? 1 : 0;
    const double mean = (space.terrain(cells[i - 1]) + space.terrain(cells[i])) / 2;
    terrain_cost += diagonal ? std::numbers::sqrt2 * mean : mean;
  }
  if (!space.uniform_terrain()) return terrain_cost;
  const double steps = cells.empty() ? 0 : static_cast<double>(cells.size() - 1);
  return (steps - diagonals) + std::numbers::sqrt2 * diagonals;
}

Expected<double, PathFault> check_grid_path(const FreeSpace& space, GridMoves moves,
                                            std::span<const Cell> cells) {
  const ExactGrid grid(space, moves);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (const auto reason = space.why_blocked(cells[i])) {
      const std::string what =
          "cell " + text_of(cells[i]) + " is " + std::string(describe(*reason));
      return Unexpected<PathFault>({i, what});
    }
    if (i > 0 && !grid.is_step(cells[i - 1], cells[i])) {
      return Unexpected<PathFault>(
          {i, text_of(cells[i - 1]) + " to " + text_of(cells[i]) + " is no step"});
    }
  }
  return grid_path_cost(space, cells);
}

}  // namespace wend
