#pragma once

// Checks the answers of an index between all cells of a small board against a plain Dijkstra.

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "wend/index/brute_distances_test.hpp"
#include "wend/index/index_engine.hpp"

namespace wend::test {

inline std::uint64_t cost_of(const OctileSteps& steps) {
  return 33461 * std::uint64_t{steps.straight} + 47321 * std::uint64_t{steps.diagonal};
}

/// Is it a path with these numbers of steps, all of them legal?
inline void expect_path(const BitGrid& bits, const std::vector<Cell>& cells,
                        const OctileSteps& steps, Cell start, Cell goal) {
  ASSERT_EQ(cells.front(), start);
  ASSERT_EQ(cells.back(), goal);
  OctileSteps counted;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const int dx = cells[i].x - cells[i - 1].x;
    const int dy = cells[i].y - cells[i - 1].y;
    ASSERT_TRUE(std::abs(dx) <= 1 && std::abs(dy) <= 1 && (dx != 0 || dy != 0));
    ASSERT_TRUE(brute_step_is_legal(bits, cells[i - 1], dx, dy));
    ++(dx != 0 && dy != 0 ? counted.diagonal : counted.straight);
  }
  ASSERT_EQ(counted, steps);
}

inline void expect_all_pairs(const BitGrid& bits, IndexEngine& engine) {
  SCOPED_TRACE(text_of(bits));
  for (const Cell start : passable_cells(bits)) {
    const auto distances = brute_distances(bits, start);
    for (const Cell goal : passable_cells(bits)) {
      if (start == goal || distances[goal] == kUnreached) continue;
      const OctileSteps steps = engine.find(start, goal);
      ASSERT_EQ(cost_of(steps), distances[goal])
          << start.x << ',' << start.y << " to " << goal.x << ',' << goal.y;
      std::vector<Cell> cells(steps.cells(), {-9, -9});
      engine.write(cells);
      ASSERT_NO_FATAL_FAILURE(expect_path(bits, cells, steps, start, goal));
    }
  }
}

}  // namespace wend::test
