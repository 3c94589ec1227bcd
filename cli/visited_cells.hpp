#pragma once

// VisitedCells: an observer that keeps the cells that a search expanded.

#include "wend/map/bit_grid.hpp"
#include "wend/planner/observer.hpp"

namespace wend::cli {

class VisitedCells final : public SearchObserver {
 public:
  /// For a map of that size.
  VisitedCells(int width, int height) : cells_(width, height) {}

  void on_generate(const SearchEvent& /*event*/) override {}
  void on_expand(const SearchEvent& event) override {
    cells_.set(event.cell, true);
    empty_ = false;
  }
  void on_relax(const SearchEvent& /*event*/) override {}

  bool empty() const { return empty_; }
  const BitGrid& cells() const { return cells_; }

 private:
  BitGrid cells_;
  bool empty_ = true;
};

}  // namespace wend::cli
