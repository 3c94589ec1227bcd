#include "wend/space/grid/heuristic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "conformance/random_map.hpp"
#include "wend/space/grid/grid_space.hpp"

namespace wend {
namespace {

constexpr std::array kKinds{HeuristicKind::zero, HeuristicKind::constant, HeuristicKind::manhattan,
                            HeuristicKind::octile, HeuristicKind::euclidean};
constexpr std::array kConnectivities{Connectivity::four, Connectivity::eight};
constexpr double kConstant = 7.5;

/// The largest violation of consistency in a space: max over steps of h(u) - c(u,v) - h(v).
template <class Space>
double worst_fall(const Space& space, HeuristicKind kind, Cell goal) {
  double worst = -1;
  for (StateId id = 0; id < space.state_count(); ++id) {
    const GridState from = space.state(id);
    if (!space.free_space().passable(from.cell)) continue;
    space.for_each_successor(from, kNoMove, [&](const GridState& to, Move, auto step_cost) {
      const double cost = static_cast<double>(step_cost) / Space::kUnitsPerCell;
      worst = std::max(worst, heuristic_value(kind, kConstant, from.cell, goal) - cost -
                                  heuristic_value(kind, kConstant, to.cell, goal));
    });
  }
  return worst;
}

TEST(Heuristic, FallsByNoMoreThanAStepCostsWhereItIsConsistent) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random);
    const FreeSpace space = *make_free_space(map);
    const Cell goal = test::random_cell(random, map.width(), map.height());
    for (const Connectivity connectivity : kConnectivities) {
      const GridMoves moves{connectivity, CornerRule::both};
      for (const HeuristicKind kind : kKinds) {
        if (!is_consistent(kind, connectivity)) continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::string(choice_name(kind)) +
                     " on " + std::string(choice_name(connectivity)) + " neighbours");
        const double worst = space.uniform_terrain()
                                 ? worst_fall(ExactGrid(space, moves), kind, goal)
                                 : worst_fall(TerrainGrid(space, moves), kind, goal);
        ASSERT_LE(worst, 1e-9);
      }
    }
  }
}

TEST(Heuristic, ManhattanIsNotConsistentOnEightNeighbours) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(4, 4, CellState::free)));
  const ExactGrid grid(space);
  EXPECT_NEAR(worst_fall(grid, HeuristicKind::manhattan, {0, 0}), 2 - std::sqrt(2), 1e-9);
  EXPECT_FALSE(is_consistent(HeuristicKind::manhattan, Connectivity::eight));
  EXPECT_TRUE(is_consistent(HeuristicKind::manhattan, Connectivity::four));
}

TEST(Heuristic, AllButManhattanAreConsistentEverywhere) {
  for (const Connectivity connectivity : kConnectivities) {
    for (const HeuristicKind kind : kKinds) {
      const bool expected = kind != HeuristicKind::manhattan || connectivity == Connectivity::four;
      EXPECT_EQ(is_consistent(kind, connectivity), expected) << choice_name(kind);
    }
    EXPECT_TRUE(is_consistent(HeuristicKind::automatic, connectivity));
  }
}

TEST(Heuristic, AutomaticIsTheExactOneOfTheConnectivity) {
  EXPECT_EQ(resolved(HeuristicKind::automatic, Connectivity::four), HeuristicKind::manhattan);
  EXPECT_EQ(resolved(HeuristicKind::automatic, Connectivity::eight), HeuristicKind::octile);
  for (const HeuristicKind kind : kKinds) {
    EXPECT_EQ(resolved(kind, Connectivity::four), kind);
    EXPECT_EQ(resolved(kind, Connectivity::eight), kind);
  }
}

TEST(Heuristic, HasTheValuesOfItsFormula) {
  const Cell from{2, 10};
  const Cell to{5, 6};  // 3 columns and 4 rows away
  const auto value = [&](HeuristicKind kind) { return heuristic_value(kind, kConstant, from, to); };
  EXPECT_EQ(value(HeuristicKind::zero), 0);
  EXPECT_EQ(value(HeuristicKind::constant), kConstant);
  EXPECT_EQ(value(HeuristicKind::manhattan), 7);
  EXPECT_NEAR(value(HeuristicKind::octile), 1 + 3 * std::sqrt(2), 1e-12);
  EXPECT_EQ(value(HeuristicKind::euclidean), 5);
  for (const HeuristicKind kind : kKinds) {
    EXPECT_EQ(heuristic_value(kind, kConstant, to, from), value(kind)) << "the same both ways";
  }
}

}  // namespace
}  // namespace wend
