#pragma once

// GoalCells: the goals of a query as the loop of a grid search asks for them.

#include <algorithm>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/planner/goal_region.hpp"

namespace wend {

class GoalCells {
 public:
  /// At least one, none of them empty. Keeps its memory from query to query.
  void assign(std::span<const GoalRegion> regions) {
    first_ = regions.front().any();
    others_.assign(regions.begin() + (regions.front().is_one_place() ? 1 : 0), regions.end());
  }

  /// O(regions).
  bool contains(Cell cell) const {
    return cell == first_ || (!others_.empty() && is_another(cell));
  }

  /// The least value(goal) over all goals, or less: over the nearest cells to `from` of their bounding boxes.
  /// O(regions).
  template <class Value>
  auto least(Cell from, Value&& value) const {
    const auto to_first = value(first_);
    return others_.empty() ? to_first : least_of_others(from, value, to_first);
  }

 private:
  // Most queries have one goal without a tolerance: what others take stays out of the loop of a search.
  [[gnu::noinline, gnu::cold]] bool is_another(Cell cell) const {
    return any_contains(others_, cell);
  }

  template <class Value, class Estimate>
  [[gnu::noinline, gnu::cold]] Estimate least_of_others(Cell from, Value& value,
                                                        Estimate least) const {
    for (const GoalRegion& region : others_) {
      least = std::min(least, value(region.nearest_in_box(from)));
    }
    return least;
  }

  Cell first_;  // also in others_, unless it is all of its region
  std::vector<GoalRegion> others_;
};

}  // namespace wend
