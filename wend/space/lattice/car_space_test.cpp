#include "wend/space/lattice/car_space.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "conformance/random_yard.hpp"
#include "tests/testing/drawn_map.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;

struct CarSuccessor {
  CarState state;
  CarMove move;
  double cost;  // in units
};

template <class Costs>
std::vector<CarSuccessor> successors(const CarSpace<Costs>& space, const CornerPose& from) {
  std::vector<CarSuccessor> found;
  space.for_each_successor(
      space.state(from), kNoMove, [&](const CarState& to, Move move, auto cost) {
        found.push_back(
            {to, static_cast<CarMove>(move), static_cast<double>(cost) / Costs::kUnitsPerCell});
      });
  return found;
}

template <class Costs>
std::vector<CarMove> moves_from(const CarSpace<Costs>& space, const CornerPose& from) {
  std::vector<CarMove> moves;
  for (const CarSuccessor& successor : successors(space, from)) moves.push_back(successor.move);
  return moves;
}

CarLattice lattice_of(std::string_view drawing, const CarDriving& driving = {}) {
  return CarLattice(test::drawn_space(drawing), driving);
}

TEST(CarSpace, NumbersPosesCornerByCorner) {
  const CarSpace<ExactCarCosts> space(lattice_of("...\n..."));
  EXPECT_EQ(space.state_count(), 4U * 3U * 4U);
  for (StateId id = 0; id < space.state_count(); ++id) {
    EXPECT_EQ(space.id(space.state(id)), id);
    EXPECT_EQ(space.state(space.state(id).place).number, id);
  }
  EXPECT_EQ(space.state({{1, 2}, Heading::plus_y}).number, (2U * 4U + 1U) * 4U + 3U);
}

TEST(CarSpace, ListsItsMovesInTheirOrder) {
  const CarSpace<ExactCarCosts> space(lattice_of("....\n....\n....\n...#"));
  EXPECT_THAT(moves_from(space, {{1, 1}, Heading::plus_x}),
              ElementsAre(CarMove::fwd, CarMove::fwd_plus, CarMove::fwd_minus, CarMove::rev,
                          CarMove::rev_plus, CarMove::rev_minus));
  EXPECT_THAT(moves_from(space, {{2, 2}, Heading::plus_y}),
              ElementsAre(CarMove::fwd, CarMove::fwd_plus, CarMove::rev, CarMove::rev_plus,
                          CarMove::rev_minus))
      << "not onto a corner of the obstacle";
  EXPECT_THAT(moves_from(space, {{0, 0}, Heading::plus_x}),
              ElementsAre(CarMove::fwd, CarMove::fwd_plus))
      << "not off the map";
}

/// On random yards with any options. Whole costs equal the real ones.
TEST(CarSpace, UndoesItsMovesAndCountsWhatTheyCost) {
  int whole = 0;
  for (std::uint64_t seed = 1; seed <= 300 && !::testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    const FreeSpace yard = *make_free_space(test::random_yard(random));
    const CarLattice lattice(
        yard, {.straight_terrain = static_cast<StraightTerrain>(random.between(0, 2))});
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(yard.map()));
    if (!has_whole_costs(lattice)) continue;
    ++whole;
    const CarSpace<RealCarCosts> real(lattice);
    const CarSpace<CompactCarCosts> compact(lattice);
    for (StateId id = 0; id < real.state_count(); ++id) {
      const CornerPose from = real.state(id).place;
      if (!lattice.passable(from.vertex)) continue;
      const std::vector<CarSuccessor> expected = successors(real, from);
      const std::vector<CarSuccessor> found = successors(compact, from);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        const CarSuccessor& to = found[i];
        EXPECT_EQ(to.state.place, moved(from, to.move));
        EXPECT_EQ(to.state.number, compact.state(to.state.place).number);
        EXPECT_EQ(compact.parent(to.state, static_cast<Move>(to.move)).place, from);
        EXPECT_EQ(compact.parent(to.state, static_cast<Move>(to.move)).number, id);
        EXPECT_EQ(to.state.place, expected[i].state.place);
        EXPECT_NEAR(to.cost, expected[i].cost, 1e-9 * to.cost);
        EXPECT_DOUBLE_EQ(expected[i].cost, lattice.ground(from, to.move) * length_of(to.move));
      }
    }
  }
  EXPECT_GT(whole, 100);
}

TEST(CarSpace, MultipliesMovesInReverse) {
  const CarSpace<RealCarCosts> space(lattice_of("22\n22", {.reverse_factor = 3}));
  for (const CarSuccessor& to : successors(space, {{1, 1}, Heading::plus_x})) {
    const double ground = is_turn(to.move) ? 2 : 1;
    EXPECT_DOUBLE_EQ(to.cost, length_of(to.move) * ground * (is_reverse(to.move) ? 3 : 1));
  }
}

TEST(CarSpace, HasWholeCostsOnGroundOfSmallWholeMultipliers) {
  EXPECT_TRUE(has_whole_costs(lattice_of("....")));
  EXPECT_TRUE(has_whole_costs(lattice_of(".5.2")));
  EXPECT_FALSE(has_whole_costs(lattice_of(".6..")));
  EXPECT_FALSE(has_whole_costs(lattice_of(".2\n..", {.unit = 2}))) << "the mean is 1.25";
  EXPECT_FALSE(has_whole_costs(lattice_of("....", {.reverse_factor = 2})));
}

}  // namespace
}  // namespace wend
