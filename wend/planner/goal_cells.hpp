#pragma once

// GoalCells: the goals of a query as the loop of a grid search asks for them.

#include <algorithm>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"

namespace wend {

class GoalCells {
 public:
  /// At least one. Keeps its memory from query to query.
  void assign(std::span<const Cell> goals) {
    first_ = goals.front();
    others_.assign(goals.begin() + 1, goals.end());
  }

  bool contains(Cell cell) const {
    return cell == first_ || (!others_.empty() && is_another(cell));
  }

  template <class Visit>
  void for_each(Visit&& visit) const {
    visit(first_);
    for (const Cell goal : others_) visit(goal);
  }

  /// The least value(goal) over all goals. O(goals).
  template <class Value>
  auto least(Value&& value) const {
    auto least = value(first_);
    for (const Cell goal : others_) least = std::min(least, value(goal));
    return least;
  }

 private:
  bool is_another(Cell cell) const {
    return std::find(others_.begin(), others_.end(), cell) != others_.end();
  }

  Cell first_;
  std::vector<Cell> others_;
};

}  // namespace wend
