#pragma once

// VisitedCells: an observer that keeps the cells that a search expanded.

#include <vector>

#include "wend/map/grid.hpp"
#include "wend/planner/observer.hpp"

namespace wend::cli {

class VisitedCells final : public SearchObserver {
 public:
  /// For a map of that size.
  VisitedCells(int width, int height) : seen_(width, height, 0) {}

  void on_generate(const SearchEvent& /*event*/) override {}
  void on_expand(const SearchEvent& event) override {
    if (seen_[event.cell] != 0) return;
    seen_[event.cell] = 1;
    cells_.push_back(event.cell);
  }
  void on_relax(const SearchEvent& /*event*/) override {}

  /// Each once, in the order of their first expansion.
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  Grid<unsigned char> seen_;  // 0 or 1
  std::vector<Cell> cells_;
};

}  // namespace wend::cli
