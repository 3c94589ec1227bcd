#include "wend/render/picture/sparse_cells.hpp"

namespace wend {
namespace {

constexpr double kMostShare = 0.05;  // of the picture that dots may cover

bool is_alone(const BitGrid& cells, Cell cell) {
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      const Cell other{x, y};
      if (other != cell && cells.contains(other) && cells[other]) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Cell> sparse_cells(const MarkedCells& marked, double pixels_a_cell, double dot) {
  const BitGrid& cells = marked.cells;
  std::vector<Cell> sparse;
  if (marked.role != CellRole::expanded || pixels_a_cell >= dot) return sparse;
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (cells[{x, y}] && is_alone(cells, {x, y})) sparse.push_back({x, y});
    }
  }
  const double pixels =
      static_cast<double>(cells.width()) * cells.height() * pixels_a_cell * pixels_a_cell;
  const double covered = static_cast<double>(sparse.size()) * dot * dot;
  if (covered > kMostShare * pixels) sparse.clear();
  return sparse;
}

}  // namespace wend
