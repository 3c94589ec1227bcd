// Checks turns and the legs between them against shortest paths by brute force.

#include "wend/index/turns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "wend/index/brute_distances_test.hpp"
#include "wend/index/corner_hierarchy/corner_hierarchy.hpp"

namespace wend {
namespace {

using test::brute_distances;
using test::brute_sees;
using test::for_small_boards;
using test::kUnreached;
using test::passable_cells;
using test::text_of;

/// The costs from a cell to each turn, by relaxing every leg until nothing changes.
std::vector<std::uint64_t> costs_of_turns(const Turns& turns, Cell from) {
  std::vector<std::uint64_t> costs(turns.size(), kUnreached);
  bool changed = true;
  const auto reach = [&](std::uint32_t turn, std::uint64_t cost) {
    if (cost >= costs[turn]) return;
    costs[turn] = cost;
    changed = true;
  };
  turns.for_each_first(from, [&](const TurnChoice& choice, std::uint64_t cost) {
    turns.for_each_of(choice, [&](std::uint32_t turn) { reach(turn, cost); });
  });
  while (changed) {
    changed = false;
    for (std::uint32_t turn = 0; turn < turns.size(); ++turn) {
      if (costs[turn] == kUnreached) continue;
      turns.for_each_next(
          turn, [&](std::uint32_t next, std::uint64_t cost) { reach(next, costs[turn] + cost); });
    }
  }
  return costs;
}

TEST(Turns, LeadByAShortestPathFromEveryCellToEveryOther) {
  for_small_boards(120, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Turns turns(bits);
    for (const Cell from : passable_cells(bits)) {
      const auto distances = brute_distances(bits, from);
      const auto costs = costs_of_turns(turns, from);
      for (std::uint32_t turn = 0; turn < turns.size(); ++turn) {
        if (costs[turn] == kUnreached) continue;
        ASSERT_GE(costs[turn], distances[turns.cell(turn)]) << "shorter than possible";
      }
      for (const Cell to : passable_cells(bits)) {
        std::uint64_t least = kUnreached;
        if (turns.sees(from, to)) least = octile_cost<CornerCost>(from, to);
        turns.for_each_last(to, [&](const TurnChoice& choice, std::uint64_t cost) {
          turns.for_each_of(choice, [&](std::uint32_t turn) {
            if (costs[turn] != kUnreached) least = std::min(least, costs[turn] + cost);
          });
        });
        ASSERT_EQ(least, distances[to]) << from.x << ',' << from.y << " to " << to.x << ',' << to.y;
      }
    }
  });
}

TEST(Turns, SeeWhatIsFreeDiagonallyFirst) {
  for_small_boards(100, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Turns turns(bits);
    for (const Cell from : passable_cells(bits)) {
      for (const Cell to : passable_cells(bits)) {
        ASSERT_EQ(turns.sees(from, to), brute_sees(bits, from, to))
            << from.x << ',' << from.y << " to " << to.x << ',' << to.y;
      }
    }
  });
}

TEST(Turns, AreJoinedByLegsThatAreFree) {
  for_small_boards(100, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Turns turns(bits);
    const auto check = [&](Cell from, Cell to, CornerCost cost) {
      ASSERT_TRUE(brute_sees(bits, from, to))
          << from.x << ',' << from.y << " to " << to.x << ',' << to.y;
      ASSERT_EQ(cost, octile_cost<CornerCost>(from, to));
    };
    for (std::uint32_t turn = 0; turn < turns.size(); ++turn) {
      std::set<std::uint32_t> seen;
      turns.for_each_next(turn, [&](std::uint32_t next, CornerCost cost) {
        ASSERT_NE(next, turn);
        ASSERT_TRUE(seen.insert(next).second) << "twice";
        check(turns.cell(turn), turns.cell(next), cost);
      });
    }
    for (const Cell cell : passable_cells(bits)) {
      turns.for_each_first(
          cell, [&](const TurnChoice& choice, CornerCost cost) { check(cell, choice.cell, cost); });
      turns.for_each_last(
          cell, [&](const TurnChoice& choice, CornerCost cost) { check(choice.cell, cell, cost); });
    }
  });
}

TEST(PathBound, RefusesMapsWhosePathsMayOutgrowThirtyTwoBits) {
  const auto corridor = [](int length) {
    BitGrid bits(length, 1);
    for (int x = 0; x < length; ++x) bits.set({x, 0}, true);
    return bits;
  };
  EXPECT_FALSE(paths_may_be_too_long(Turns(corridor(1000)), {}));
  EXPECT_FALSE(paths_may_be_too_long(Turns(corridor(120'000)), {})) << "that many are fine";
  EXPECT_TRUE(paths_may_be_too_long(Turns(corridor(130'000)), {}));
}

/// One winding corridor, one cell wide; its length is proportional to the area.
BitGrid snake(int size) {
  BitGrid bits(size, size);
  for (int y = 0; y < size; y += 2) {
    for (int x = 0; x < size; ++x) bits.set({x, y}, true);
    if (y + 2 < size) bits.set({y % 4 == 0 ? size - 1 : 0, y + 1}, true);
  }
  return bits;
}

TEST(PathBound, MeasuresPathsAlongTheirTurns) {
  const auto too_long = [](const BitGrid& bits) {
    const Turns turns(bits);
    std::vector<GraphArc> arcs;
    for (std::uint32_t turn = 0; turn < turns.size(); ++turn) {
      turns.for_each_next(
          turn, [&](std::uint32_t next, CornerCost cost) { arcs.push_back({turn, next, cost}); });
    }
    return paths_may_be_too_long(turns, arcs);
  };
  EXPECT_FALSE(too_long(snake(340))) << "58,000 cells long: twice that fits";
  EXPECT_TRUE(too_long(snake(520))) << "135,000 cells long";
}

}  // namespace
}  // namespace wend
