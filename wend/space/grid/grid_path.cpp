#include "wend/space/grid/grid_path.hpp"

#include <numbers>

#include "wend/space/grid/grid_space.hpp"

namespace wend {
namespace {

std::string text_of(Cell cell) {
  return '(' + std::to_string(cell.x) + ',' + std::to_string(cell.y) + ')';
}

// Branch-free: paths are long, and their turns are hard to predict.
bool is_diagonal_step(Cell from, Cell to) {
  return (static_cast<unsigned>(from.x != to.x) & static_cast<unsigned>(from.y != to.y)) != 0;
}

double uniform_cost(std::span<const Cell> cells) {
  std::size_t diagonals = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const bool diagonal = is_diagonal_step(cells[i - 1], cells[i]);
    diagonals += static_cast<std::size_t>(diagonal);
  }
  const std::size_t steps = cells.empty() ? 0 : cells.size() - 1;
  return static_cast<double>(steps - diagonals) +
         std::numbers::sqrt2 * static_cast<double>(diagonals);
}

}  // namespace

double grid_path_cost(const FreeSpace& space, std::span<const Cell> cells) {
  if (space.uniform_terrain()) return uniform_cost(cells);
  double cost = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const double mean = (space.terrain(cells[i - 1]) + space.terrain(cells[i])) / 2;
    cost += is_diagonal_step(cells[i - 1], cells[i]) ? std::numbers::sqrt2 * mean : mean;
  }
  return cost;
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
