// Corners and the first corners of cells, beside rays that are cast step by step.

#include "wend/index/first_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "tests/testing/random_cells.hpp"
#include "tests/testing/share.hpp"
#include "wend/index/brute_distances_test.hpp"

namespace wend {
namespace {

class Board {
 public:
  explicit Board(const BitGrid& passable) : passable_(passable) {}

  bool is_free(Cell cell) const { return passable_.contains(cell) && passable_[cell]; }

  /// May a path that comes to a cell in a straight direction turn there around an obstacle?
  bool is_jump_point(Cell cell, Cell ahead) const {
    if (!is_free({cell.x - ahead.x, cell.y - ahead.y})) return false;
    for (const int side : {-1, 1}) {
      const Cell beside{cell.x - side * ahead.y, cell.y + side * ahead.x};
      if (is_free(beside) && !is_free({beside.x - ahead.x, beside.y - ahead.y})) return true;
    }
    return false;
  }

  /// Is an obstacle diagonally beside it, with free cells on both sides?
  bool is_corner(Cell cell) const {
    for (const int dx : {-1, 1}) {
      for (const int dy : {-1, 1}) {
        if (!is_free({cell.x + dx, cell.y + dy}) && is_free({cell.x + dx, cell.y}) &&
            is_free({cell.x, cell.y + dy})) {
          return is_free(cell);
        }
      }
    }
    return false;
  }

  /// Where rays from a cell and from its diagonals turn first.
  std::set<std::pair<int, int>> first_corners(Cell from) const {
    std::set<std::pair<int, int>> found;
    if (!is_free(from)) return found;
    for (const int dx : {-1, 1}) {
      for (const int dy : {-1, 1}) {
        for (Cell cell = from;; cell = {cell.x + dx, cell.y + dy}) {
          cast(cell, {dx, 0}, found);
          cast(cell, {0, dy}, found);
          if (!test::brute_step_is_legal(passable_, cell, dx, dy)) break;
        }
      }
    }
    return found;
  }

 private:
  void cast(Cell cell, Cell ahead, std::set<std::pair<int, int>>& found) const {
    do {
      cell = {cell.x + ahead.x, cell.y + ahead.y};
      if (!is_free(cell)) return;
    } while (!is_jump_point(cell, ahead));
    found.insert({cell.x, cell.y});
  }

  const BitGrid& passable_;
};

/// Calls check(passable, board) for random boards.
template <class Check>
void for_random_boards(Check&& check) {
  for (int seed = 1; seed <= test::share_of(300) && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const BitGrid passable = test::random_cells(random, seed % 10 == 0 ? 80 : 14, 0.4);
    check(passable, Board(passable));
  }
}

TEST(Corners, AreCellsBesideConvexObstaclesInOrder) {
  for_random_boards([](const BitGrid& passable, const Board& board) {
    const Corners corners(passable);
    std::uint32_t count = 0;
    for (const Cell cell : every_cell(passable)) {
      const bool is_corner = board.is_corner(cell);
      ASSERT_EQ(corners.contains(cell), is_corner) << cell.x << ',' << cell.y;
      ASSERT_EQ(corners.number(cell), is_corner ? count : Corners::kNone);
      if (!is_corner) continue;
      ASSERT_EQ(corners.cell(count), cell);
      ++count;
    }
    ASSERT_EQ(corners.size(), count);
  });
}

TEST(FirstCorners, AreWhereRaysTurnFirst) {
  for_random_boards([](const BitGrid& passable, const Board& board) {
    const Corners corners(passable);
    const AllFirstCorners first(corners);
    for (const Cell cell : every_cell(passable)) {
      std::set<std::pair<int, int>> found;
      const auto of_cell = first.of(cell);
      for (const std::uint32_t corner : of_cell) {
        found.insert({corners.cell(corner).x, corners.cell(corner).y});
      }
      ASSERT_EQ(found, board.first_corners(cell)) << cell.x << ',' << cell.y;
      ASSERT_EQ(found.size(), of_cell.size()) << "each once";
      ASSERT_TRUE(std::ranges::is_sorted(of_cell));
    }
  });
}

TEST(CellComponents, AreTheCellsWithTheSameFirstCorners) {
  for_random_boards([](const BitGrid& passable, const Board& board) {
    const Corners corners(passable);
    const AllFirstCorners first(corners);
    const CellComponents components(corners, first);
    std::set<std::pair<int, int>> seen;
    for (std::size_t i = 0; i < components.size(); ++i) {
      const auto cells = components.cells(i);
      ASSERT_FALSE(cells.empty());
      for (const Cell cell : cells) {
        ASSERT_TRUE(board.is_free(cell) && !board.is_corner(cell));
        ASSERT_TRUE(seen.insert({cell.x, cell.y}).second) << "in two components";
        ASSERT_EQ(board.first_corners(cell), board.first_corners(cells.front()));
      }
    }
    for (const Cell cell : every_cell(passable)) {
      const bool counts = board.is_free(cell) && !board.is_corner(cell);
      ASSERT_EQ(seen.contains({cell.x, cell.y}), counts);
    }
  });
}

}  // namespace
}  // namespace wend
