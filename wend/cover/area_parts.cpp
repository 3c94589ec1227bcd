#include "wend/cover/area_parts.hpp"

#include <array>
#include <cstdint>

#include "wend/map/distance_field.hpp"
#include "wend/map/grid.hpp"

namespace wend {
namespace {

constexpr std::array<Cell, 8> kAround{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// Spreads labels over the cells that are left, breadth first.
class Labels {
 public:
  explicit Labels(const BitGrid& left) : left_(left), labels_(left.width(), left.height(), 0) {}

  std::uint32_t& operator[](Cell cell) { return labels_[cell]; }

  /// From these cells to those that `accepts` accepts. `cells` becomes all of them.
  template <class Accepts>
  void spread(std::vector<Cell>& cells, Accepts&& accepts) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Cell from = cells[i];
      for (const Cell by : kAround) {
        const Cell to{from.x + by.x, from.y + by.y};
        if (!left_[to] || labels_[to] != 0 || !accepts(to)) continue;
        labels_[to] = labels_[from];
        cells.push_back(to);
      }
    }
  }

 private:
  const BitGrid& left_;
  Grid<std::uint32_t> labels_;
};

}  // namespace

std::vector<std::vector<Cell>> parts_left(const CoverageArea& area) {
  const BitGrid& left = area.left();
  const Grid<std::uint32_t> depth = squared_half_cell_distances(left.complement());
  const double reach = 2 * area.reach() / 3 * 2;  // in half-cells, of a door that parts two rooms
  const auto is_core = [&](Cell cell) { return depth[cell] >= reach * reach; };
  Labels labels(left);
  std::uint32_t parts = 0;
  const auto begin_part = [&](Cell cell, auto&& accepts) {
    labels[cell] = ++parts;
    std::vector<Cell> cells{cell};
    labels.spread(cells, accepts);
    return cells;
  };
  std::vector<Cell> front;
  for (const Cell cell : every_cell(left)) {
    if (!left[cell] || labels[cell] != 0 || !is_core(cell)) continue;
    const std::vector<Cell> cells = begin_part(cell, is_core);
    front.insert(front.end(), cells.begin(), cells.end());
  }
  const auto any = [](Cell) { return true; };
  labels.spread(front, any);
  for (const Cell cell : every_cell(left)) {
    if (left[cell] && labels[cell] == 0) begin_part(cell, any);
  }
  std::vector<std::vector<Cell>> cells(parts);
  for (const Cell cell : every_cell(left)) {
    if (left[cell]) cells[labels[cell] - 1].push_back(cell);
  }
  return cells;
}

}  // namespace wend
