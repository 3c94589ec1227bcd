#include "tests/testing/share.hpp"
#include "wend/space/grid/grid_moves.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

#include "conformance/random_map.hpp"
#include "wend/space/grid/grid_space.hpp"

namespace wend {
namespace {

constexpr unsigned kBlocks = 512;

constexpr std::array<GridMoves, 6> kAllMoves{{{Connectivity::four, CornerRule::none},
                                              {Connectivity::four, CornerRule::one},
                                              {Connectivity::four, CornerRule::both},
                                              {Connectivity::eight, CornerRule::none},
                                              {Connectivity::eight, CornerRule::one},
                                              {Connectivity::eight, CornerRule::both}}};

std::string text_of(GridMoves moves) {
  return std::string(choice_name(moves.connectivity)) + " neighbours, corner rule " +
         std::string(choice_name(moves.corner_rule));
}

/// The bits of a block by name, as the header lays them out.
enum Bit : unsigned {
  kMinusXPlusY = 1U << 0U,
  kPlusY = 1U << 1U,
  kPlusXPlusY = 1U << 2U,
  kMinusX = 1U << 3U,
  kMiddle = 1U << 4U,
  kPlusX = 1U << 5U,
  kMinusXMinusY = 1U << 6U,
  kMinusY = 1U << 7U,
  kPlusXMinusY = 1U << 8U,
};

/// A move, the cell that it leads to, and for a diagonal one the two cells beside it.
struct Rule {
  Direction direction;
  unsigned target;
  unsigned beside;
};

constexpr std::array<Rule, 8> kRules{
    {{Direction::plus_y, kPlusY, 0},
     {Direction::plus_x_plus_y, kPlusXPlusY, kPlusY | kPlusX},
     {Direction::plus_x, kPlusX, 0},
     {Direction::plus_x_minus_y, kPlusXMinusY, kMinusY | kPlusX},
     {Direction::minus_y, kMinusY, 0},
     {Direction::minus_x_minus_y, kMinusXMinusY, kMinusY | kMinusX},
     {Direction::minus_x, kMinusX, 0},
     {Direction::minus_x_plus_y, kMinusXPlusY, kPlusY | kMinusX}}};

bool is_legal(const Rule& rule, GridMoves moves, unsigned block) {
  if ((block & kMiddle) == 0 || (block & rule.target) == 0) return false;
  if (rule.beside == 0) return true;
  if (moves.connectivity == Connectivity::four) return false;
  const unsigned open = block & rule.beside;
  if (moves.corner_rule == CornerRule::none) return open == rule.beside;
  return moves.corner_rule == CornerRule::both || open != 0;
}

TEST(MoveTable, HoldsTheLegalMovesOfEveryBlock) {
  for (const GridMoves moves : kAllMoves) {
    SCOPED_TRACE(text_of(moves));
    const MoveTable table(moves);
    for (unsigned block = 0; block < kBlocks; ++block) {
      DirectionSet expected = 0;
      for (const Rule& rule : kRules) {
        if (!is_legal(rule, moves, block)) continue;
        expected =
            static_cast<DirectionSet>(expected | 1U << static_cast<unsigned>(rule.direction));
      }
      ASSERT_EQ(table.moves(kNoMove, block), expected) << "block " << block;
      for (Move arrival = 0; arrival < kDirections; ++arrival) {
        ASSERT_EQ(table.moves(arrival, block), expected) << "unpruned, arrivals do not matter";
      }
    }
  }
}

TEST(CanonicalMoveTable, LeavesMovesOutAndAddsNone) {
  for (const GridMoves moves : kAllMoves) {
    SCOPED_TRACE(text_of(moves));
    const MoveTable all(moves);
    const MoveTable canonical(moves, MoveTable::Pruning::canonical);
    for (unsigned block = 0; block < kBlocks; ++block) {
      ASSERT_EQ(canonical.moves(kNoMove, block), all.moves(kNoMove, block));
      for (Move arrival = 0; arrival < kDirections; ++arrival) {
        ASSERT_EQ(canonical.moves(arrival, block) & ~all.moves(arrival, block), 0);
      }
    }
  }
}

/// Without obstacles a straight move continues straight, and a diagonal one splits into three.
TEST(CanonicalMoveTable, IsThinInTheOpen) {
  const MoveTable table({}, MoveTable::Pruning::canonical);
  const auto moves_after = [&](Direction arrival) {
    return table.moves(static_cast<Move>(arrival), kBlocks - 1);
  };
  const auto set_of = [](auto... directions) {
    return static_cast<DirectionSet>(((1U << static_cast<unsigned>(directions)) | ...));
  };
  EXPECT_EQ(moves_after(Direction::plus_x), set_of(Direction::plus_x));
  EXPECT_EQ(moves_after(Direction::minus_y), set_of(Direction::minus_y));
  EXPECT_EQ(moves_after(Direction::minus_x_plus_y),
            set_of(Direction::minus_x_plus_y, Direction::plus_y, Direction::minus_x));
}

/// The cheapest cost of every cell from `start`, found by a search that keeps the first of equal paths
/// and breaks ties between equal costs at random.
std::vector<std::uint64_t> costs_from(const ExactGrid& grid, Cell start, Random& random) {
  using Open = std::tuple<std::uint64_t, std::uint64_t, StateId>;  // cost, tie, state
  constexpr std::uint64_t kUnreached = UINT64_MAX;
  std::vector<std::uint64_t> costs(grid.state_count(), kUnreached);
  std::vector<Move> arrivals(grid.state_count(), kNoMove);
  std::vector<bool> closed(grid.state_count());
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  costs[grid.state(start).number] = 0;
  open.emplace(0, 0, grid.state(start).number);
  while (!open.empty()) {
    const auto [cost, tie, id] = open.top();
    open.pop();
    if (closed[id]) continue;
    closed[id] = true;
    grid.for_each_successor(grid.state(id), arrivals[id],
                            [&](const GridState& next, Move move, std::uint64_t step) {
                              if (costs[id] + step >= costs[next.number]) return;
                              costs[next.number] = costs[id] + step;
                              arrivals[next.number] = move;
                              open.emplace(costs[next.number], random.bits(), next.number);
                            });
  }
  return costs;
}

TEST(CanonicalMoveTable, KeepsACheapestPathToEveryCell) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random);
    const FreeSpace space =
        *make_free_space(map, test::random_robot(random, map.frame().resolution));
    const Cell start = test::random_cell(random, map.width(), map.height());
    if (!space.passable(start)) continue;
    for (const GridMoves moves : kAllMoves) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + text_of(moves) + ", from " +
                   std::to_string(start.x) + "," + std::to_string(start.y) + "\n" +
                   test::drawing_of(map));
      const ExactGrid all(space, moves);
      const ExactGrid canonical(space, moves, MoveTable::Pruning::canonical);
      ASSERT_EQ(costs_from(canonical, start, random), costs_from(all, start, random));
    }
  }
}

TEST(CanonicalMoveTable, KeepsACheapestPathOnCrowdedMaps) {
  for (std::uint64_t seed = 1; seed <= test::share_of(150U); ++seed) {
    Random random(seed);
    Grid<CellState> states(7, 7, CellState::free);
    for (int i = 0; i < 49; ++i) {
      if (random.chance(0.35)) states[{i % 7, i / 7}] = CellState::occupied;
    }
    const FreeSpace space = *make_free_space(*make_grid_map(states));
    for (const GridMoves moves : kAllMoves) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + text_of(moves) + "\n" +
                   test::drawing_of(space.map()));
      const ExactGrid all(space, moves);
      const ExactGrid canonical(space, moves, MoveTable::Pruning::canonical);
      for (int i = 0; i < 49; i += 3) {
        const Cell start{i % 7, i / 7};
        if (!space.passable(start)) continue;
        ASSERT_EQ(costs_from(canonical, start, random), costs_from(all, start, random));
      }
    }
  }
}

}  // namespace
}  // namespace wend
