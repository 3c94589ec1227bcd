#pragma once

// CellComponents: the passable cells of a map that are no corners, grouped by their first corners.
// Cells side by side mostly have the same ones, so what an index knows of them is kept once.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/index/corners.hpp"
#include "wend/index/first_corners.hpp"

namespace wend {

class CellComponents {
 public:
  /// O(the lists of all cells). Components are numbered by their first cell, row by row.
  CellComponents(const Corners& corners, const AllFirstCorners& first);

  std::size_t size() const { return begins_.size() - 1; }

  /// Never empty.
  std::span<const Cell> cells(std::size_t component) const {
    return std::span(cells_).subspan(begins_[component],
                                     begins_[component + 1] - begins_[component]);
  }

 private:
  std::vector<std::size_t> begins_{0};  // by component, and the end
  std::vector<Cell> cells_;
};

}  // namespace wend
