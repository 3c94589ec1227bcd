#include "wend/jump/jump_boards.hpp"

#include <gtest/gtest.h>

#include <string>

#include "wend/base/random.hpp"

namespace wend {
namespace {

/// The same questions, answered one cell at a time by the definitions.
class SlowBoards {
 public:
  explicit SlowBoards(const BitGrid& cells) : cells_(cells) {}

  bool passable(Cell cell) const { return cells_.contains(cell) && cells_[cell]; }

  bool legal(Cell cell, Direction direction) const {
    const Cell next = step(cell, direction, 1);
    return passable(cell) && passable(next) && passable({next.x, cell.y}) &&
           passable({cell.x, next.y});
  }

  bool is_jump_point(Cell cell, Direction travel) const {
    const Cell last = step(cell, travel, -1);
    return passable(cell) && passable(last) &&
           (forced(cell, last, turned(travel, 2)) || forced(cell, last, turned(travel, -2)));
  }

  int distance_to_stop(Cell cell, Direction travel) const {
    int distance = 1;
    for (;; ++distance) {
      const Cell next = step(cell, travel, distance);
      if (!passable(next) || is_jump_point(next, travel)) return distance;
    }
  }

  bool has_ray(Cell cell, Direction travel) const {
    return passable(step(cell, travel, distance_to_stop(cell, travel)));
  }

  int distance_to_diagonal_stop(Cell cell, Direction travel) const {
    for (int distance = 1;; ++distance) {
      const Cell at = step(cell, travel, distance);
      if (has_ray(at, turned(travel, 1)) || has_ray(at, turned(travel, -1)) || !legal(at, travel)) {
        return distance;
      }
    }
  }

 private:
  bool forced(Cell cell, Cell last, Direction side) const {
    return passable(step(cell, side, 1)) && !passable(step(last, side, 1));
  }

  const BitGrid& cells_;
};

BitGrid random_board(Random& random) {
  const int width = random.between(1, random.chance(0.2) ? 150 : 20);
  const int height = random.between(1, random.chance(0.2) ? 150 : 20);
  const double share = random.uniform();
  BitGrid cells(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) cells.set({x, y}, random.chance(share));
  }
  return cells;
}

template <Direction kStraight>
void expect_same_run(const JumpBoards& boards, const SlowBoards& slow, Cell cell) {
  EXPECT_EQ(boards.distance_to_stop<kStraight>(cell), slow.distance_to_stop(cell, kStraight));
  EXPECT_EQ((boards.moves(cell) & set_of(kStraight)) != 0, slow.has_ray(cell, kStraight));
}

template <Direction kDiagonal>
void expect_same_diagonal(const JumpBoards& boards, const SlowBoards& slow, Cell cell) {
  const bool legal = slow.legal(cell, kDiagonal);
  EXPECT_EQ((boards.moves(cell) & set_of(kDiagonal)) != 0, legal);
  if (!legal) return;
  EXPECT_EQ(boards.distance_to_stop<kDiagonal>(cell),
            slow.distance_to_diagonal_stop(cell, kDiagonal));
}

TEST(JumpBoards, SayWhatTheDefinitionsSay) {
  Random random(11);
  for (int map = 0; map < 150 && !::testing::Test::HasFailure(); ++map) {
    const BitGrid cells = random_board(random);
    const JumpBoards boards(cells);
    const SlowBoards slow(cells);
    for (int y = 0; y < cells.height(); ++y) {
      for (int x = 0; x < cells.width(); ++x) {
        if (!cells[{x, y}]) continue;
        SCOPED_TRACE("map " + std::to_string(map) + ", cell " + std::to_string(x) + ',' +
                     std::to_string(y));
        expect_same_run<Direction::plus_y>(boards, slow, {x, y});
        expect_same_run<Direction::plus_x>(boards, slow, {x, y});
        expect_same_run<Direction::minus_y>(boards, slow, {x, y});
        expect_same_run<Direction::minus_x>(boards, slow, {x, y});
        expect_same_diagonal<Direction::plus_x_plus_y>(boards, slow, {x, y});
        expect_same_diagonal<Direction::plus_x_minus_y>(boards, slow, {x, y});
        expect_same_diagonal<Direction::minus_x_minus_y>(boards, slow, {x, y});
        expect_same_diagonal<Direction::minus_x_plus_y>(boards, slow, {x, y});
      }
    }
  }
}

}  // namespace
}  // namespace wend
