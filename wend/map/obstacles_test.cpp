#include "wend/map/obstacles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/share.hpp"

namespace wend {
namespace {

/// Brute-force distances from the centre of a cell to the nearest blocked square, and to the edge.
struct Nearest {
  double square = test::kInfinite;
  double edge = 0;
};

Nearest nearest_to(const Obstacles& obstacles, Cell from) {
  Nearest nearest;
  for (const Cell cell : every_cell(obstacles.map())) {
    if (!obstacles.blocked()[cell]) continue;
    nearest.square =
        std::min(nearest.square, test::distance_to_square(from.x + 0.5, from.y + 0.5, cell));
  }
  const GridMap& map = obstacles.map();
  nearest.edge =
      std::min({from.x, from.y, map.width() - 1 - from.x, map.height() - 1 - from.y}) + 0.5;
  return nearest;
}

TEST(Obstacles, AreWhatThePoliciesSay) {
  for (std::uint64_t seed = 1; seed <= test::share_of(300U) && !testing::Test::HasFailure();
       ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random);
    for (const UnknownPolicy unknown : {UnknownPolicy::blocked, UnknownPolicy::free}) {
      for (const OutsidePolicy outside : {OutsidePolicy::blocked, OutsidePolicy::free}) {
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
        const Obstacles obstacles(map, {unknown, outside});
        for (const Cell cell : every_cell(map)) {
          const CellState state = map.state(cell);
          const bool blocked = state == CellState::occupied ||
                               (state == CellState::unknown && unknown == UnknownPolicy::blocked);
          ASSERT_EQ(obstacles.blocked()[cell], blocked);
          const Nearest nearest = nearest_to(obstacles, cell);
          const bool edge = outside == OutsidePolicy::blocked;
          ASSERT_DOUBLE_EQ(obstacles.clearance(cell),
                           edge ? std::min(nearest.square, nearest.edge) : nearest.square);
          ASSERT_EQ(obstacles.edge_is_nearest(cell), edge && nearest.edge <= nearest.square + 1e-9);
        }
      }
    }
  }
}

TEST(Obstacles, WithoutAPolicyBlockTheOutsideOfMapsInMetres) {
  const Grid<CellState> cells(3, 3, CellState::free);
  EXPECT_EQ(Obstacles(*make_grid_map(cells)).outside(), OutsidePolicy::free);
  EXPECT_EQ(Obstacles(*make_grid_map(cells, {.resolution = 0.1, .metric = true})).outside(),
            OutsidePolicy::blocked);
}

}  // namespace
}  // namespace wend
