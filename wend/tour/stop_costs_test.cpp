#include "wend/tour/stop_costs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <limits>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_cells.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/tour/plan_tour.hpp"
#include "wend/tour/tour_path.hpp"

namespace wend {
namespace {

MapPose middle_of(const Frame& frame, Cell cell) {
  return frame.to_metres(Pose{cell.x + 0.5, cell.y + 0.5, 0});
}

/// Some passable cells of a space, with repetitions.
std::vector<Cell> random_stops(Random& random, const FreeSpace& space, int count) {
  std::vector<Cell> stops;
  for (int tries = 0; tries < 100 && static_cast<int>(stops.size()) < count; ++tries) {
    const Cell cell = test::random_cell(random, space.width(), space.height());
    if (space.passable(cell)) stops.push_back(cell);
  }
  return stops;
}

std::vector<MapPose> poses_of(const Frame& frame, const std::vector<Cell>& cells) {
  std::vector<MapPose> poses;
  for (const Cell cell : cells) poses.push_back(middle_of(frame, cell));
  return poses;
}

TEST(StopCosts, AreThoseOfTheReferenceOnRandomMaps) {
  int pairs = 0;
  int without = 0;
  for (int seed = 1; seed <= test::share_of(150) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map = test::random_map(random, random.between(2, 12), random.between(2, 12));
    Session session(map);
    const auto view = session.view();
    const auto cells = random_stops(random, view->space, 5);
    if (cells.empty()) continue;
    const auto found = stop_costs(session, *view, poses_of(map.frame(), cells));
    ASSERT_TRUE(found) << found.error().message;
    const test::Reference book(map, {}, {true, 0});
    for (std::size_t from = 0; from < cells.size(); ++from) {
      const auto costs = book.costs_from(cells[from]);
      for (std::size_t to = 0; to < cells.size(); ++to) {
        const double expected = from == to ? 0 : costs[book.number(cells[to])];
        const double cost = found->costs(static_cast<int>(from), static_cast<int>(to));
        ++pairs;
        if (expected == test::kInfinite) {
          ++without;
          ASSERT_EQ(cost, CostMatrix::kNoWay);
        } else {
          ASSERT_NEAR(cost, expected, 1e-5 * (1 + expected));
        }
      }
    }
  }
  EXPECT_GT(pairs, without);
  EXPECT_GT(without, 0);
}

TEST(StopCosts, AreTheSameByFieldsByLabelsAndOnManyThreads) {
  const GridMap map = test::drawn_map(R"(
..........
.###..###.
.#......#.
.#.####.#.
.#......#.
.###..###.
..........
)");
  Session session(map);
  const auto view = session.view();
  const auto stops = poses_of(map.frame(), {{0, 0}, {4, 2}, {2, 4}, {9, 6}, {5, 4}});
  const auto fields = stop_costs(session, *view, stops);
  ASSERT_TRUE(fields) << fields.error().message;
  ASSERT_TRUE(session.build_index("hub_labels"));
  ThreadWorkers workers(2);
  const auto labels =
      stop_costs(session, *view, stops, {.planner = {"hub_labels", {}}, .workers = &workers});
  ASSERT_TRUE(labels) << labels.error().message;
  for (int from = 0; from < 5; ++from) {
    for (int to = 0; to < 5; ++to) {
      EXPECT_NEAR(labels->costs(from, to), fields->costs(from, to), 1e-9);
    }
  }
  EXPECT_EQ(fields->costs(0, 3), 15) << "around two walls";
}

TEST(StopCosts, NameTheStopsThatAreCutOff) {
  const GridMap map = test::drawn_map("..#..#.");
  Session session(map);
  const auto found = stop_costs(session, *session.view(),
                                poses_of(map.frame(), {{0, 0}, {3, 0}, {1, 0}, {6, 0}, {0, 0}}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->cut_off, (std::vector<int>{1, 3}));
  EXPECT_EQ(cut_off_text(*found),
            "stops 1, 3 are cut off: no paths join them to most of the others");
}

TEST(StopCosts, NameTheStopWhereTheRobotCannotBe) {
  const GridMap map = test::drawn_map("..#");
  Session session(map);
  const auto error_of = [&](MapPose stop) {
    const std::array stops{middle_of(map.frame(), {0, 0}), stop};
    return stop_costs(session, *session.view(), stops).error();
  };
  EXPECT_EQ(error_of(middle_of(map.frame(), {2, 0})).status, Status::start_blocked);
  EXPECT_EQ(error_of(middle_of(map.frame(), {2, 0})).where, "stop 1");
  EXPECT_EQ(error_of(middle_of(map.frame(), {3, 0})).status, Status::start_outside);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -infinite}) {
    EXPECT_EQ(error_of({bad, 0, 0}).status, Status::unsupported_query);
  }
  EXPECT_EQ(error_of({1e300, 0, 0}).status, Status::start_outside);
}

TEST(StopCosts, EndWhenTheyAreCancelled) {
  const GridMap map = test::drawn_map("...");
  Session session(map);
  const auto view = session.view();
  const std::atomic<bool> cancel = true;
  StopCostOptions options;
  options.limits.cancel = &cancel;
  const auto stops = poses_of(map.frame(), {{0, 0}, {2, 0}});
  EXPECT_EQ(stop_costs(session, *view, stops, options).error().status, Status::cancelled);
}

TEST(TourPath, PassesItsStopsFreelyAndCostsWhatTheMatrixSays) {
  const GridMap map = test::drawn_map(R"(
..........
.###..###.
.#......#.
.#.####.#.
..........
)");
  Session session(map);
  const auto view = session.view();
  const auto stops = poses_of(map.frame(), {{0, 0}, {4, 2}, {2, 2}, {9, 4}, {5, 4}});
  ASSERT_TRUE(session.build_index("euclidean_labels"));
  for (const char* planner : {"astar", "theta_star", "euclidean_labels", "lattice"}) {
    for (const bool closed : {false, true}) {
      SCOPED_TRACE(planner);
      const StopCostOptions options{.planner = {planner, {}}};
      const auto costs = stop_costs(session, *view, stops, options);
      ASSERT_TRUE(costs) << costs.error().message;
      ASSERT_TRUE(costs->cut_off.empty());
      const auto tour = plan_tour(costs->costs, {.closed = closed});
      ASSERT_TRUE(tour);
      const auto path = tour_path(session, *view, stops, tour->order, closed, options);
      ASSERT_TRUE(path) << path.error().message;
      ASSERT_EQ(path->legs.size(), closed ? 5U : 4U);
      EXPECT_FALSE(first_collision(path->path, view->space, {}));
      const auto points = path->path.points();
      double sum = 0;
      for (const TourLeg& leg : path->legs) {
        sum += leg.cost;
        const Pose from = map.frame().to_grid(stops[static_cast<std::size_t>(leg.from)]);
        EXPECT_LT(distance(points[leg.first], from.point()), 0.75);
      }
      EXPECT_NEAR(sum, tour->cost, 1e-9);
    }
  }
}

}  // namespace
}  // namespace wend
