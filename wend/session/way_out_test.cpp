#include "wend/session/way_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/map/masked.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/sweep/overlap.hpp"

namespace wend {
namespace {

double to_square(Point point, Cell cell) {
  const double dx = std::max({cell.x - point.x, point.x - cell.x - 1, 0.0});
  const double dy = std::max({cell.y - point.y, point.y - cell.y - 1, 0.0});
  return std::hypot(dx, dy);
}

/// How deep a disc is in blocked squares, by the definition, over all cells.
class Depths {
 public:
  explicit Depths(const FreeSpace& space) : space_(space) {}

  double at(Point point) const {
    const BitGrid& blocked = space_.obstacles().blocked();
    double to_blocked = HUGE_VAL;
    double to_free = HUGE_VAL;
    for (const Cell cell : every_cell(blocked)) {
      double& least = blocked[cell] ? to_blocked : to_free;
      least = std::min(least, to_square(point, cell));
    }
    if (space_.outside() == OutsidePolicy::blocked) {
      to_blocked = std::min(
          {to_blocked, point.x, point.y, space_.width() - point.x, space_.height() - point.y});
    }
    const double radius = space_.radius_in_cells();
    return blocked[cell_at(point)] ? radius + to_free : std::max(0.0, radius - to_blocked);
  }

  /// Does it never grow along a line?
  bool never_grow(Point from, Point to) const {
    double before = at(from);
    for (int i = 1; i <= 23; ++i) {
      const double share = i / 23.0;
      const double here = at({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
      if (here > before + 1e-5) return false;
      before = here;
    }
    return true;
  }

 private:
  const FreeSpace& space_;
};

/// The least length of a way from the cell to a passable one, by relaxing all steps until nothing changes.
double least_way(const FreeSpace& space, Cell start, bool diagonals) {
  const Depths depths(space);
  const BitGrid& blocked = space.obstacles().blocked();
  struct Step {
    Cell from, to;
    double length;
  };
  std::vector<Step> steps;
  for (const Cell from : every_cell(blocked)) {
    if (space.passable(from)) continue;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell to{from.x + dx, from.y + dy};
        if ((dx == 0 && dy == 0) || !space.contains(to)) continue;
        if (dx != 0 && dy != 0) {
          const bool corner = blocked[{from.x, to.y}] || blocked[{to.x, from.y}];
          if (!diagonals || (corner && depths.at(centre_of(from)) <= space.radius_in_cells())) {
            continue;
          }
        }
        if (depths.never_grow(centre_of(from), centre_of(to))) {
          steps.push_back({from, to, std::hypot(dx, dy)});
        }
      }
    }
  }
  Grid<double> least(space.width(), space.height(), HUGE_VAL);
  least[start] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Step& step : steps) {
      if (least[step.from] + step.length >= least[step.to] - 1e-9) continue;
      least[step.to] = least[step.from] + step.length;
      changed = true;
    }
  }
  double best = HUGE_VAL;
  for (const Cell cell : every_cell(blocked)) {
    if (space.passable(cell)) best = std::min(best, least[cell]);
  }
  return best;
}

FreeSpace random_space(Random& random) {
  Grid<CellState> states(11, 9, CellState::free);
  for (int block = random.between(1, 5); block > 0; --block) {
    const Cell low{random.between(0, 10), random.between(0, 8)};
    const Cell size{random.between(1, 4), random.between(1, 4)};
    for (const Cell cell : every_cell(states)) {
      const bool inside =
          cell.x >= low.x && cell.y >= low.y && cell.x < low.x + size.x && cell.y < low.y + size.y;
      if (inside) states[cell] = CellState::occupied;
    }
  }
  return *make_free_space(
      *make_grid_map(states),
      {.footprint = Footprint::disc(random.chance(0.4) ? 0 : 1.2),
       .outside = random.chance(0.5) ? OutsidePolicy::blocked : OutsidePolicy::free});
}

TEST(WayOut, OverCellsIsTheShortestAlongWhichTheDepthNeverGrows) {
  int ways = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(60U); ++seed) {
    Random random(seed);
    const FreeSpace space = random_space(random);
    const bool diagonals = random.chance(0.7);
    const GridMoves moves{diagonals ? Connectivity::eight : Connectivity::four};
    const Cell start{random.between(0, 10), random.between(0, 8)};
    if (space.passable(start)) continue;
    const double expected = least_way(space, start, diagonals);
    const auto way = way_out_over_cells(space, moves, start, 100);
    ASSERT_EQ(way.has_value(), expected < HUGE_VAL) << "seed " << seed;
    if (!way) continue;
    ++ways;
    EXPECT_NEAR(way->length, expected, 1e-9) << "seed " << seed;
    EXPECT_NEAR(way->path.length(), expected, 1e-9);
    EXPECT_TRUE(space.passable(way->path.cells().back()));
    const auto points = way->path.points();
    for (std::size_t i = 1; i < points.size(); ++i) {
      EXPECT_TRUE(Depths(space).never_grow(points[i - 1], points[i])) << "seed " << seed;
    }
    EXPECT_FALSE(way_out_over_cells(space, moves, start, way->length - 0.01)) << "too long";
    EXPECT_TRUE(way_out_over_cells(space, moves, start, way->length));
  }
  EXPECT_GT(ways, test::share_of(10));
}

/// A zone along a wall, with the way out on the other side of the wall as near.
GridMap zone_along_wall() {
  const GridMap map = test::drawn_map(
      ".........\n"
      ".........\n"
      "#########\n"
      ".........\n"
      ".........\n"
      ".........\n"
      ".........\n"
      ".........\n");
  Grid<CellState> zone(9, 8, CellState::free);
  for (int x = 0; x < 9; ++x) {
    for (int y = 1; y <= 5; ++y) zone[{x, y}] = CellState::occupied;
  }
  return *masked(map, *make_grid_map(zone));
}

TEST(WayOut, OfAZoneDoesNotLeadThroughAWall) {
  const FreeSpace space = *make_free_space(zone_along_wall());
  const auto way = way_out_over_cells(space, {}, {4, 3}, 100);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->path.cells().back().y, 6);
  EXPECT_DOUBLE_EQ(way->length, 3);
}

struct Robot {
  const char* planner;
  OptionValues options;
};

class DrivenWayOut : public ::testing::TestWithParam<Robot> {};

TEST_P(DrivenWayOut, NeverGoesDeeperAndEndsWhereThePlannerBegins) {
  const Footprint box = *parse_footprint("2.2,0.8; -0.9,0.8; -0.9,-0.8; 2.2,-0.8");
  int ways = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(200U); ++seed) {
    Random random(seed);
    Grid<CellState> states(24, 20, CellState::free);
    for (int i = random.between(1, 14); i > 0; --i) {
      states[{random.between(0, 23), random.between(0, 19)}] = CellState::occupied;
    }
    const bool round = random.chance(0.5);
    const FreeSpace space =
        *make_free_space(*make_grid_map(states), {.footprint = round ? Footprint::disc(1.4) : box});
    const auto planner = make_planner(GetParam().planner, space, GetParam().options);
    ASSERT_TRUE(planner) << planner.error().message;
    const Pose start{24 * random.uniform(), 20 * random.uniform(), 2 * kPi * random.uniform()};
    if (!is_blocked_start(**planner, start)) continue;
    const auto way = way_out(**planner, start, 4);
    if (!way) continue;
    ++ways;
    const auto poses = way->path.driven_poses();
    EXPECT_EQ(poses.front(), (*planner)->place_of(start));
    EXPECT_EQ((*planner)->nearest_free(Goal(poses.back())), poses.back().point());
    EXPECT_LE(way->path.length(), 4 + 1e-6);
    const OverlapMeasure measure(space);
    Overlap before = measure.at(poses.front());
    for (const Segment& segment : way->path.segments()) {
      for (int i = 1; i <= 40; ++i) {
        const Overlap here = measure.at(pose_on(segment, i / 40.0));
        EXPECT_FALSE(here.exceeds(before, 2e-3)) << "seed " << seed;
        before = here.least(before);
      }
    }
    EXPECT_TRUE(before.none());
  }
  EXPECT_GT(ways, test::share_of(5));
}

INSTANTIATE_TEST_SUITE_P(
    Planners, DrivenWayOut,
    ::testing::Values(Robot{"hybrid_astar", {{"turning_radius", "2"}}},
                      Robot{"hybrid_astar", {{"motion_model", "dubins"}, {"turning_radius", "2"}}},
                      Robot{"hybrid_astar", {{"motion_model", "differential"}}},
                      Robot{"hybrid_astar", {{"motion_model", "omni"}}}, Robot{"lattice", {}},
                      Robot{"lattice", {{"turning_radius", "2"}}}, Robot{"car", {}},
                      Robot{"car", {{"lattice_resolution", "2"}}}));

}  // namespace
}  // namespace wend
