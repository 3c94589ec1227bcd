#include "wend/space/lattice/car_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "conformance/random_yard.hpp"

namespace wend {
namespace {

using Car = CarSteps<RealCarCosts>;
using Corners = CornerSpace<RealCarCosts>;

/// The cheapest step to each neighbour.
std::map<Cell, double> steps_from(const Corners& corners, Cell from) {
  std::map<Cell, double> steps;
  corners.for_each_successor(
      corners.state(from), kNoMove, [&](const Corners::State& to, Move move, double cost) {
        EXPECT_EQ(to.number, corners.state(to.place).number);
        EXPECT_EQ(corners.parent(to, move).place.vertex, from);
        EXPECT_EQ(corners.parent(to, move).number, corners.state(from).number);
        const auto [entry, is_new] = steps.try_emplace(to.place.vertex, cost);
        if (!is_new) entry->second = std::min(entry->second, cost);
      });
  return steps;
}

/// The cheapest move ahead to each neighbour, with any heading.
std::map<Cell, double> drives_from(const Car& car, Cell from) {
  std::map<Cell, double> drives;
  for (const Heading heading : kAllHeadings) {
    car.for_each_of({from, heading}, Car::kMovesAhead, [&](const CarStep& step, Move, double cost) {
      const Cell to = Car::after({from, heading}, step).vertex;
      const auto [entry, is_new] = drives.try_emplace(to, cost);
      if (!is_new) entry->second = std::min(entry->second, cost);
    });
  }
  return drives;
}

TEST(CornerSpace, NumbersCorners) {
  const CarLattice lattice(*make_free_space(*make_grid_map(Grid<CellState>(4, 2, CellState::free))),
                           {});
  const Corners corners((Car(lattice)));
  EXPECT_EQ(corners.state_count(), 5U * 3U);
  for (StateId id = 0; id < corners.state_count(); ++id) {
    EXPECT_EQ(corners.id(corners.state(id)), id);
    EXPECT_EQ(corners.state(corners.state(id).place).number, id);
  }
}

/// The steps are those of a car with any heading, with the same cost from both ends.
TEST(CornerSpace, HasTheStepsOfACarThatTurnsOnTheSpot) {
  for (std::uint64_t seed = 1; seed <= 200 && !::testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_yard(random);
    const FreeSpace yard =
        *make_free_space(map, test::random_car(random, map.frame().resolution, 1));
    const CarLattice lattice(
        yard, {.straight_terrain = static_cast<StraightTerrain>(random.between(0, 2))});
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    const Car car(lattice);
    const Corners corners(car);
    for (StateId id = 0; id < corners.state_count(); ++id) {
      const Cell from = corners.state(id).place.vertex;
      if (!lattice.passable(from)) continue;
      const std::map<Cell, double> steps = steps_from(corners, from);
      EXPECT_EQ(steps, drives_from(car, from));
      for (const auto& [to, cost] : steps) EXPECT_EQ(steps_from(corners, to).at(from), cost);
    }
  }
}

}  // namespace
}  // namespace wend
