#include "wend/space/se2/coarse_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/space/se2/motion_check.hpp"

namespace wend {
namespace {

constexpr double kRoom = 1.5;
constexpr float kFactor = 4;

FreeSpace random_space(Random& random) {
  const int width = random.between(1, 150);
  const int height = random.between(1, 20);
  const double blocked = 0.2 * random.uniform();
  const bool costs = random.chance(0.5);
  Grid<CellState> states(width, height, CellState::free);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (random.chance(blocked)) states[{x, y}] = CellState::occupied;
    }
  }
  const double radius = random.chance(0.5) ? 0 : 2 * random.uniform();
  const bool squeezes = random.chance(0.3);  // a polygon gets where its disc does not
  const Footprint footprint =
      squeezes ? *Footprint::rectangle(3, 1 + random.uniform(), 2) : Footprint::disc(radius);
  const double cost = random.chance(0.5) ? 3 : 5 * random.uniform();
  return *make_free_space(*make_grid_map(states), {.footprint = footprint,
                                                   .clearance_distance = costs ? 2.5 : 0,
                                                   .clearance_cost = costs ? cost : 0});
}

Grid<CellState> states_of(const GridMap& map) {
  Grid<CellState> states(map.width(), map.height(), CellState::free);
  for (const Cell cell : every_cell(states)) states[cell] = map.state(cell);
  return states;
}

/// The cells of a square that are drivable.
template <class Visit>
void for_each_cell_of(int column, int row, int size, const BitGrid& drivable, Visit&& visit) {
  for (int i = 0; i < size * size; ++i) {
    const Cell cell{column * size + i % size, row * size + i / size};
    if (drivable.contains(cell) && drivable[cell]) visit(cell);
  }
}

/// The sides across which a drivable cell of the square has a drivable neighbour.
unsigned sides_of(int column, int row, int size, const BitGrid& drivable) {
  unsigned sides = 0;
  for_each_cell_of(column, row, size, drivable, [&](Cell cell) {
    const auto leaves = [&](Cell next, unsigned side) {
      const bool inside =
          next.x >= 0 && next.y >= 0 && next.x / size == column && next.y / size == row;
      if (!inside && drivable.contains(next) && drivable[next]) sides |= side;
    };
    leaves({cell.x + 1, cell.y}, CoarseGrid::kRight);
    leaves({cell.x - 1, cell.y}, CoarseGrid::kLeft);
    leaves({cell.x, cell.y + 1}, CoarseGrid::kAbove);
    leaves({cell.x, cell.y - 1}, CoarseGrid::kBelow);
  });
  return sides;
}

TEST(CoarseGrid, KnowsTheLeastCostAndTheSidesOfEverySquare) {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = random_space(random);
    const BitGrid& drivable = space.possible();
    const int size = random.between(1, random.chance(0.2) ? CoarseGrid::kMostSize : 9);
    const CoarseGrid grid(space, drivable, size);
    CoarseGrid charged(grid);
    charged.charge_narrow_squares(space, kRoom, kFactor);
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        float least = std::numeric_limits<float>::infinity();
        double room = 0;
        for_each_cell_of(column, row, size, drivable, [&](Cell cell) {
          least = std::min(least, static_cast<float>(driving_multiplier(space, cell)));
          room = std::max(room, space.clearance(cell));
        });
        const std::size_t square = grid.index(column, row);
        ASSERT_EQ(grid.multiplier(square), least);
        ASSERT_EQ(unsigned{grid.sides(square)}, sides_of(column, row, size, drivable));
        const bool wide = room >= space.inscribed_radius_in_cells() + kRoom;
        ASSERT_EQ(charged.multiplier(square), wide ? least : kFactor * least);
      }
    }
  }
}

/// The base point is in a drivable cell wherever the robot fits, also on edges, and a robot that moves a little stays in
/// cells that are connected by edges.
TEST(CellsToDriveIn, AreThoseInWhichTheBasePointCanBe) {
  int fitted = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace ground = random_space(random);
    const double length = 0.3 + 3 * random.uniform();
    const double ahead =
        length / 2 + 3 * random.uniform();  // of the rear edge: the base point is behind it
    const FreeSpace space = *make_free_space(
        *make_grid_map(states_of(ground.map())),
        {.footprint = *Footprint::rectangle(length, 0.3 + random.uniform(), ahead),
         .outside = random.chance(0.5) ? OutsidePolicy::free : OutsidePolicy::blocked});
    const BitGrid cells = cells_to_drive_in(space);
    for (const Cell cell : every_cell(space)) {
      ASSERT_TRUE(cells[cell] || !space.possible()[cell]);
    }
    for (int i = 0; i < 200; ++i) {
      const bool on_edges = random.chance(0.5);
      Pose pose{space.width() * random.uniform(), space.height() * random.uniform(),
                2 * kPi * random.uniform()};
      if (on_edges) pose = {std::floor(pose.x), std::floor(pose.y), kPi / 2 * random.between(0, 3)};
      if (!space.fits(pose)) continue;
      ++fitted;
      for (const double dx : {0.0, -1e-9}) {
        for (const double dy : {0.0, -1e-9}) {
          const Cell cell = cell_at({pose.x + dx, pose.y + dy});
          ASSERT_TRUE(!space.contains(cell) || cells[cell]);
        }
      }
    }
  }
  EXPECT_GT(fitted, 10'000);
}

}  // namespace
}  // namespace wend
