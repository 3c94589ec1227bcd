#include "wend/cover/plan_coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

/// Rooms with noise: walls with doors, and obstacles of a few cells.
GridMap random_rooms(Random& random) {
  const int width = random.between(8, 36);
  const int height = random.between(8, 36);
  Grid<CellState> states(width, height, CellState::free);
  for (int wall = random.between(0, 2); wall > 0; --wall) {
    const int x = random.between(2, width - 3);
    const int door = random.between(0, height - 1);
    for (int y = 0; y < height; ++y) {
      if (std::abs(y - door) > 4) states[{x, y}] = CellState::occupied;
    }
  }
  const double blocked = 0.02 * random.uniform();
  for (const Cell cell : every_cell(states)) {
    if (random.chance(blocked)) states[cell] = CellState::occupied;
    if (random.chance(0.002)) states[cell] = CellState::unknown;
  }
  return *make_grid_map(states);
}

/// From a point to a closed square, without the library's geometry.
double gap(Point p, Cell square) {
  const double dx = std::max({square.x - p.x, p.x - square.x - 1, 0.0});
  const double dy = std::max({square.y - p.y, p.y - square.y - 1, 0.0});
  return std::sqrt(dx * dx + dy * dy);
}

double gap(Point a, Point b, Point p) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double t =
      squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
  const double ex = p.x - a.x - t * dx;
  const double ey = p.y - a.y - t * dy;
  return std::sqrt(ex * ex + ey * ey);
}

/// A disc on a map, known cell by cell.
class Reference {
 public:
  Reference(const GridMap& map, double radius) : map_(map), radius_(radius) {}

  bool fits(Point p) const {
    if (!map_.contains({static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))}))
      return false;
    for (const Cell cell : every_cell(map_)) {
      if (map_.state(cell) != CellState::free && gap(p, cell) < radius_ - 1e-6) return false;
    }
    return true;
  }

  /// The cells that a robot in a cell can reach by steps over edges.
  Grid<char> reached(Cell from) const {
    Grid<char> reached(map_.width(), map_.height(), 0);
    std::vector<Cell> open{from};
    reached[from] = 1;
    while (!open.empty()) {
      const Cell at = open.back();
      open.pop_back();
      for (const Cell to : {Cell{at.x + 1, at.y}, Cell{at.x - 1, at.y}, Cell{at.x, at.y + 1},
                            Cell{at.x, at.y - 1}}) {
        if (!map_.contains(to) || reached[to] != 0 || !fits({to.x + 0.5, to.y + 0.5})) continue;
        reached[to] = 1;
        open.push_back(to);
      }
    }
    return reached;
  }

  /// The free cells of which the centre is near one of these.
  bool wanted(Cell cell, const Grid<char>& reached, double reach) const {
    if (map_.state(cell) != CellState::free) return false;
    return std::ranges::any_of(every_cell_of(reached), [&](Cell at) {
      return reached[at] != 0 && std::hypot(at.x - cell.x, at.y - cell.y) <= reach + 1e-9;
    });
  }

  /// The least distance of the tool's middle from the centre of a cell.
  static double nearest(const std::vector<Point>& path, Cell cell) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < path.size(); ++i) {
      least = std::min(least, gap(path[i == 0 ? 0 : i - 1], path[i], {cell.x + 0.5, cell.y + 0.5}));
    }
    return least;
  }

  bool free_along(const std::vector<Point>& path) const {
    constexpr double kStep = 0.2;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Point a = path[i == 0 ? 0 : i - 1];
      const Point b = path[i];
      const int steps = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / kStep);
      for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        if (!fits({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)})) return false;
      }
    }
    return true;
  }

 private:
  static std::vector<Cell> every_cell_of(const Grid<char>& grid) {
    std::vector<Cell> cells;
    for (const Cell cell : every_cell(grid)) cells.push_back(cell);
    return cells;
  }

  const GridMap& map_;
  double radius_;
};

GridMap empty_room(int width, int height) {
  Grid<CellState> states(width, height, CellState::occupied);
  for (int y = 1; y + 1 < height; ++y) {
    for (int x = 1; x + 1 < width; ++x) states[{x, y}] = CellState::free;
  }
  return *make_grid_map(states);
}

FreeSpace space_of(const GridMap& map, double radius) {
  return *make_free_space(map, {.footprint = Footprint::disc(radius)});
}

/// On random maps: the path is free, begins and ends where it has to, and covers what it says; that is at least the
/// share that was asked for of what a tool in the middle of the robot can reach.
TEST(PlanCoverage, CoversWhatItSaysWithoutCollisions) {
  int planned = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(40U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const GridMap map = random_rooms(random);
    const double radius = 0.5 + 2.5 * random.uniform();
    const FreeSpace space = space_of(map, radius);
    const Cell start{random.between(0, map.width() - 1), random.between(0, map.height() - 1)};
    if (!space.passable(start)) continue;
    // As wide as the robot, narrower or wider.
    CoverageOptions options{.tool_width = random.chance(0.5) ? 2 * std::max(1.0, radius)
                                                             : 2 + 6 * random.uniform()};
    if (random.chance(0.3)) options.overlap = 0.5 * random.uniform() * options.tool_width;
    if (random.chance(0.3)) options.angle = kPi * random.uniform();
    options.start = centre_of(start);
    options.share = random.chance(0.5) ? 1 : 0.97;
    const auto coverage = plan_coverage(space, options);
    ASSERT_TRUE(coverage) << coverage.error().message;
    ++planned;
    const Reference reference(map, radius);
    const std::vector<Point> path = coverage->path.points();
    ASSERT_FALSE(path.empty());
    EXPECT_EQ(path.front(), centre_of(start));
    EXPECT_TRUE(reference.free_along(path));
    const double reach = options.tool_width / 2;
    const Grid<char> reached = reference.reached(start);
    std::size_t wanted = 0;
    std::size_t covered = 0;
    for (const Cell cell : every_cell(map)) {
      ASSERT_EQ(coverage->wanted[cell], reference.wanted(cell, reached, reach))
          << cell.x << ',' << cell.y;
      if (!coverage->wanted[cell]) continue;
      ++wanted;
      const double away = Reference::nearest(path, cell);
      covered += coverage->covered[cell] ? 1 : 0;
      if (std::abs(away - reach) < 1e-6) continue;
      ASSERT_EQ(coverage->covered[cell], away <= reach) << cell.x << ',' << cell.y;
    }
    const double share = static_cast<double>(covered) / static_cast<double>(wanted);
    EXPECT_NEAR(coverage->covered_share, share, 1e-12);
    EXPECT_GE(share, options.share - 1e-12);
  }
  EXPECT_GT(planned, test::share_of(15));
}

/// The bound holds: a path covers at most its length times the tool's width, and the tool's own disc.
TEST(PlanCoverage, IsNotShorterThanItsBound) {
  for (std::uint64_t seed = 1; seed <= test::share_of(30U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = space_of(random_rooms(random), 1.5);
    const double width = 3;
    const auto coverage = plan_coverage(space, {.tool_width = width});
    if (!coverage) continue;
    EXPECT_GE(coverage->length + 2 * width, coverage->lower_bound);
  }
}

TEST(PlanCoverage, TakesLittleMoreThanItsBoundInAHall) {
  const auto coverage = plan_coverage(space_of(empty_room(122, 82), 3.5), {.tool_width = 7});
  ASSERT_TRUE(coverage) << coverage.error().message;
  EXPECT_GE(coverage->covered_share, 0.999);
  EXPECT_LE(coverage->length, 1.12 * coverage->lower_bound);
}

TEST(PlanCoverage, BeginsAndEndsWhereItIsTold) {
  CoverageOptions options{.tool_width = 4};
  options.start = Point{3.25, 3.5};
  options.end = Point{20.5, 15.75};
  const auto coverage = plan_coverage(space_of(empty_room(30, 20), 2), options);
  ASSERT_TRUE(coverage) << coverage.error().message;
  EXPECT_EQ(coverage->path.points().front(), *options.start);
  EXPECT_EQ(coverage->path.points().back(), *options.end);
}

TEST(PlanCoverage, LaysSwathsAtTheGivenAngle) {
  for (const double angle : {0.0, kPi / 4, kPi / 2}) {
    CoverageOptions options{.tool_width = 4};
    options.angle = angle;
    const auto coverage = plan_coverage(space_of(empty_room(60, 60), 2), options);
    ASSERT_TRUE(coverage) << coverage.error().message;
    double along = 0;
    const std::vector<Point> points = coverage->path.points();
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Line line{points[i - 1], points[i]};
      if (std::abs(std::sin(line.heading() - angle)) < 1e-6) along += line.length();
    }
    EXPECT_GT(along, 0.6 * coverage->length) << angle;
  }
}

TEST(PlanCoverage, GoesOnWhereItWasInterrupted) {
  const FreeSpace space = space_of(empty_room(40, 40), 2);
  const CoverageOptions all{.tool_width = 4};
  const auto whole = plan_coverage(space, all);
  ASSERT_TRUE(whole) << whole.error().message;
  CoverageOptions rest = all;
  rest.covered = whole->covered;
  for (const Cell cell : every_cell(*rest.covered)) {
    if (cell.x >= 20) rest.covered->set(cell, false);
  }
  const auto half = plan_coverage(space, rest);
  ASSERT_TRUE(half) << half.error().message;
  EXPECT_LT(half->length, 0.7 * whole->length);
  EXPECT_GE(half->covered_share, 0.999);
  rest.covered = half->covered;
  rest.share = half->covered_share;
  const auto none = plan_coverage(space, rest);
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_TRUE(none->path.empty());
  EXPECT_EQ(none->length, 0);
}

TEST(PlanCoverage, CoversOnlyTheArea) {
  const FreeSpace space = space_of(empty_room(60, 40), 2);
  CoverageOptions options{.tool_width = 4};
  options.area.emplace(60, 40);
  for (int y = 5; y < 15; ++y) {
    for (int x = 5; x < 15; ++x) options.area->set({x, y}, true);
  }
  const auto coverage = plan_coverage(space, options);
  ASSERT_TRUE(coverage) << coverage.error().message;
  EXPECT_EQ(coverage->wanted.count(), 100U);
  EXPECT_LT(coverage->length, 60);
}

TEST(PlanCoverage, IsTheSameForTheSameSeed) {
  const FreeSpace space = space_of(empty_room(50, 30), 2);
  const auto first = plan_coverage(space, {.tool_width = 4, .seed = 7});
  const auto second = plan_coverage(space, {.tool_width = 4, .seed = 7});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->path, second->path);
}

TEST(PlanCoverage, SaysWhyAPlaceWasMissed) {
  Grid<CellState> states(40, 20, CellState::free);
  for (int y = 0; y < 20; ++y) {
    if (y != 9 && y != 10) states[{20, y}] = CellState::occupied;
  }
  const FreeSpace space = space_of(*make_grid_map(states), 1.5);
  CoverageOptions options{.tool_width = 3};
  options.start = Point{5.5, 5.5};
  const auto coverage = plan_coverage(space, options);
  ASSERT_TRUE(coverage) << coverage.error().message;
  const auto missed = missed_places(space, *coverage, 1);
  ASSERT_EQ(missed.size(), 1U);
  EXPECT_FALSE(missed[0].reachable);
  EXPECT_GT(missed[0].cells, 300U);
  ASSERT_TRUE(missed[0].radius);
  EXPECT_NEAR(*missed[0].radius, 0.5, 1e-9);  // in the middle of a cell of the door
}

TEST(PlanCoverage, RefusesWrongOptions) {
  const FreeSpace space = space_of(empty_room(20, 20), 2);
  const auto where_of = [&](const CoverageOptions& options) {
    const auto coverage = plan_coverage(space, options);
    return coverage ? std::string("none") : coverage.error().where;
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double width : {0.0, -1.0, 1.5, 501.0, 1e9, kNan, kInfinity}) {
    EXPECT_EQ(where_of({.tool_width = width}), "tool_width") << width;
  }
  for (const double overlap : {-0.1, 4.0, kNan, kInfinity}) {
    EXPECT_EQ(where_of({.tool_width = 4, .overlap = overlap}), "overlap") << overlap;
  }
  for (const double number : {kNan, kInfinity, 1e300}) {
    EXPECT_EQ(where_of({.tool_width = 4, .angle = number}), "angle") << number;
    EXPECT_EQ(where_of({.tool_width = 4, .turn_cost = number}), "turn_cost") << number;
    EXPECT_EQ(where_of({.tool_width = 4, .share = number}), "share") << number;
    EXPECT_EQ(where_of({.tool_width = 4, .start = Point{number, 3}}), "start") << number;
    EXPECT_EQ(where_of({.tool_width = 4, .end = Point{3, number}}), "end") << number;
  }
  EXPECT_EQ(where_of({.tool_width = 4, .share = 0}), "share");
  EXPECT_EQ(where_of({.tool_width = 4, .area = BitGrid(3, 3)}), "area");
  EXPECT_EQ(where_of({.tool_width = 4, .covered = BitGrid(20, 3)}), "covered");
}

TEST(PlanCoverage, SaysWhereTheRobotCannotBe) {
  const FreeSpace space = space_of(empty_room(20, 20), 2);
  const auto status_of = [](const FreeSpace& on, const CoverageOptions& options) {
    const auto coverage = plan_coverage(on, options);
    return coverage ? Status::found : coverage.error().status;
  };
  EXPECT_EQ(status_of(space, {.tool_width = 4, .start = Point{0.5, 0.5}}), Status::start_blocked);
  EXPECT_EQ(status_of(space, {.tool_width = 4, .start = Point{-5, 0.5}}), Status::start_outside);
  EXPECT_EQ(status_of(space, {.tool_width = 4, .end = Point{0.5, 0.5}}), Status::goal_blocked);
  EXPECT_EQ(status_of(space, {.tool_width = 4, .end = Point{50, 0.5}}), Status::goal_outside);
  EXPECT_EQ(status_of(space_of(empty_room(20, 20), 15), {.tool_width = 4}), Status::unreachable);
}

TEST(PlanCoverage, StopsWhenItIsCancelled) {
  const std::atomic<bool> cancel = true;
  CoverageOptions options{.tool_width = 4};
  options.limits.cancel = &cancel;
  const auto coverage = plan_coverage(space_of(empty_room(40, 40), 2), options);
  ASSERT_FALSE(coverage);
  EXPECT_EQ(coverage.error().status, Status::cancelled);
}

}  // namespace
}  // namespace wend
