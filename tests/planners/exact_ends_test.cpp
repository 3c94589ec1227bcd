// with_ends() behind a planner, on random maps.

#include "wend/path/exact_ends.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/testing/random_cells.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

/// For robots of all sizes on random maps: free, from the point if the piece to the centre is, and never longer than
/// by these pieces.
TEST(ExactEnds, AreFreeAndWhereTheyWereAskedForWheneverThePieceToTheCentreIsFree) {
  int exact_ends = 0;
  int kept_centres = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(2000U) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const BitGrid free = test::random_cells(random, 12, 0.25);
    Grid<CellState> states(free.width(), free.height(), CellState::free);
    for (const Cell cell : every_cell(states)) {
      if (!free[cell]) states[cell] = CellState::occupied;
    }
    const double radius = random.chance(0.4) ? 0 : random.uniform();
    const FreeSpace space =
        *make_free_space(*make_grid_map(states), {.footprint = Footprint::disc(radius)});
    const Cell start = test::random_cell(random, free.width(), free.height());
    const Cell goal = test::random_cell(random, free.width(), free.height());
    const auto plan = (*make_planner("astar", space))->plan(Query::between(start, goal));
    if (!plan) continue;
    const auto somewhere_in = [&](Cell cell) {
      return Point{cell.x + random.uniform(), cell.y + random.uniform()};
    };
    const PathEnds ends{somewhere_in(start), somewhere_in(goal)};
    const Path path = with_ends(plan->path, ends, space);
    EXPECT_FALSE(first_collision(path, space));
    const std::vector<Point> points = path.points();
    double most = plan->path.length();
    const auto expect_end = [&](Point end, Point asked, Cell cell) {
      const Path piece = Path::along({asked, centre_of(cell)});
      const bool is_free = !first_collision(piece, space);
      most += piece.length();
      EXPECT_TRUE(end == asked || !is_free);
      EXPECT_TRUE(end == asked || end == centre_of(cell));
      (end == asked ? exact_ends : kept_centres) += 1;
    };
    expect_end(points.front(), ends.start, start);
    expect_end(points.back(), ends.goal, goal);
    EXPECT_LE(path.length(), most + 1e-9);
  }
  EXPECT_GT(exact_ends, test::share_of(400));
  EXPECT_GT(kept_centres, test::share_of(30));
}

}  // namespace
}  // namespace wend
