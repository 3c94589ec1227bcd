#pragma once

// Landmarks: lower bounds of the cost between two cells, from the exact costs of some landmarks to all cells. By the
// triangle inequality, |d(L, a) - d(L, b)| is at most the cost from a to b. (A. Goldberg and C. Harrelson,
// "Computing the Shortest Path: A* Search Meets Graph Theory", 2005.)
//
// Each landmark is as far from the others as possible. Costs are in the units of the searches, so the bounds are
// consistent to the last digit. They stay bounds while cells only become dearer or blocked.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "wend/base/deadline.hpp"
#include "wend/base/state_id.hpp"
#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/goal_region.hpp"

namespace wend {

class Landmarks {
 public:
  /// The costs of `count` landmarks on a grid, fewer if the map has fewer cells or costs outgrow 32 bits. They lie
  /// in the component of the first free cell and others that are far from it. O(count * cells), 4 bytes a cell
  /// and landmark. None if the deadline passes before.
  template <class Word>
  static std::shared_ptr<const Landmarks> make(const CostGrid<Word>& grid, unsigned count,
                                               DeadlineCheck& stop = DeadlineCheck::never());

  std::size_t count() const { return count_; }

  /// Can the cost between two cells have become less by these changes?
  template <class Word>
  static bool may_fall(const CostGrid<Word>& grid,
                       std::span<const typename CostGrid<Word>::Change> changes) {
    return std::ranges::any_of(changes,
                               [&](const auto& change) { return grid.became_better(change); });
  }

  /// The landmarks that are best for a query with one goal, and its bounds.
  class Bounds {
   public:
    /// Without landmarks every bound is 0.
    Bounds() = default;

    Bounds(std::shared_ptr<const Landmarks> landmarks, StateId start, StateId goal);

    /// No path from the cell to the goal costs less.
    std::uint64_t operator()(StateId id) const {
      std::uint64_t most = 0;
      for (std::size_t i = 0; i < used_; ++i) {
        const std::uint32_t here = costs_[id * stride_ + which_[i]];
        const std::uint32_t there = at_goal_[i];
        const std::uint32_t bound = here > there ? here - there : there - here;
        most = bound > most ? bound : most;
      }
      return most;
    }

   private:
    static constexpr std::size_t kMost = 3;

    std::shared_ptr<const Landmarks> landmarks_;
    const std::uint32_t* costs_ = nullptr;
    std::size_t stride_ = 0;
    std::size_t used_ = 0;
    std::array<std::size_t, kMost> which_{};
    std::array<std::uint32_t, kMost> at_goal_{};
  };

 private:
  static constexpr std::uint32_t kUnreached = ~std::uint32_t{0};

  std::size_t count_ = 0;
  std::vector<std::uint32_t, LargePages<std::uint32_t>> costs_;  // by cell, then by landmark
};

}  // namespace wend
