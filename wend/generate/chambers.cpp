#include "wend/generate/chambers.hpp"

#include "wend/geometry/direction.hpp"

namespace wend {
namespace {

/// The positions of walls along one axis: at both ends, and evenly between chambers.
std::vector<int> wall_lines(int size, int chamber) {
  const int chambers = std::max(1, (size - 1) / (chamber + 1));
  std::vector<int> lines;
  for (int i = 0; i <= chambers; ++i) lines.push_back(i * (size - 1) / chambers);
  return lines;
}

}  // namespace

Chambers::Chambers(int width, int height, int chamber)
    : wall_columns_(wall_lines(width, chamber)),
      wall_rows_(wall_lines(height, chamber)),
      cells_(width, height, CellState::free) {
  for (const int x : wall_columns_) fill(cells_, {x, 0, 1, height}, CellState::occupied);
  for (const int y : wall_rows_) fill(cells_, {0, y, width, 1}, CellState::occupied);
}

Block Chambers::wall_between(Cell a, Cell b) const {
  const auto column = static_cast<std::size_t>(b.x);
  const auto row = static_cast<std::size_t>(b.y);
  const int x = wall_columns_[column];
  const int y = wall_rows_[row];
  if (a.y == b.y) return {x, y + 1, 1, wall_rows_[row + 1] - y - 1};
  return {x + 1, y, wall_columns_[column + 1] - x - 1, 1};
}

std::vector<std::pair<Cell, Cell>> random_spanning_tree(int columns, int rows, Random& random) {
  Grid<unsigned char> visited(columns, rows, 0);
  std::vector<std::pair<Cell, Cell>> tree;
  std::vector<Cell> walk{{0, 0}};
  visited[{0, 0}] = 1;
  while (!walk.empty()) {
    const Cell here = walk.back();
    std::array<Cell, 4> unvisited;
    std::size_t choices = 0;
    for (const Direction way : kStraightDirections) {
      const Cell next = step(here, way);
      if (visited.contains(next) && visited[next] == 0) unvisited[choices++] = next;
    }
    if (choices == 0) {
      walk.pop_back();
      continue;
    }
    const Cell next = unvisited[random.below(choices)];
    visited[next] = 1;
    tree.emplace_back(std::min(here, next), std::max(here, next));
    walk.push_back(next);
  }
  return tree;
}

}  // namespace wend
