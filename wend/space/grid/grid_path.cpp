#include "wend/space/grid/grid_path.hpp"

#include <numbers>
#include <optional>

#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/point_sweep.hpp"
#include "wend/space/grid/grid_space.hpp"
#include "wend/space/grid/line_cost.hpp"

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

/// The first cell that is blocked, or to which the path does not lead: `joined(before, cell)`.
template <class Joined>
std::optional<PathFault> first_fault(const FreeSpace& space, std::span<const Cell> cells,
                                     const Joined& joined, const std::string& if_not) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (const auto reason = space.why_blocked(cells[i])) {
      return PathFault{i, "cell " + text_of(cells[i]) + " is " + std::string(describe(*reason))};
    }
    if (i > 0 && !joined(cells[i - 1], cells[i])) {
      return PathFault{i, text_of(cells[i - 1]) + " to " + text_of(cells[i]) + ' ' + if_not};
    }
  }
  return std::nullopt;
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
  const auto is_step = [&](Cell from, Cell to) { return grid.is_step(from, to); };
  if (auto fault = first_fault(space, cells, is_step, "is no step")) {
    return Unexpected<PathFault>(*std::move(fault));
  }
  return grid_path_cost(space, cells);
}

Expected<double, PathFault> check_any_angle_path(const FreeSpace& space, Adjacency adjacency,
                                                 std::span<const Cell> cells) {
  const auto is_free = [&](Cell from, Cell to) {
    return disc_fits_along(space, Line{centre_of(from), centre_of(to)}, adjacency);
  };
  if (auto fault = first_fault(space, cells, is_free, "is not free")) {
    return Unexpected<PathFault>(*std::move(fault));
  }
  return any_angle_path_cost(space, cells);
}

Expected<double, PathFault> check_any_angle_path(const FreeSpace& space, Adjacency adjacency,
                                                 std::span<const Point> waypoints) {
  double length = 0;
  if (waypoints.empty()) return length;
  PointSweep point(space, waypoints.front(), adjacency);
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const Line line{waypoints[i - 1], waypoints[i]};
    const bool free =
        space.is_point() ? point.go_to(line.to) : disc_fits_along(space, line, adjacency);
    if (!free) {
      return Unexpected<PathFault>(PathFault{i, "line " + std::to_string(i) + " is not free"});
    }
    length += line.length();
  }
  return length;
}

}  // namespace wend
