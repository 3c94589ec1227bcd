// Every planner that guarantees optimal paths on 8 neighbours, on tens of thousands of small maps that
// are nasty to jump on (gaps one cell wide, diagonal squeezes, borders, words' ends), all against a
// reference Dijkstra that shares no code with wend.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "wend/base/random.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kEqualRelative = 1e-9;

/// Noise, walls with gaps, stripes of diagonal squeezes, or corridors that go round in circles.
GridMap nasty_map(Random& random, int width, int height) {
  Grid<CellState> cells(width, height, CellState::free);
  const int kind = random.between(0, 4);
  const double share = 0.6 * random.uniform();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool wall = kind == 1   ? (x % 4 == 2 && random.chance(0.85))
                        : kind == 2 ? (y % 3 == 1 && random.chance(0.8))
                        : kind == 3 ? ((x + y) % 5 == 0 && random.chance(0.9))
                        : kind == 4 ? ((x % 4 != 0 && y % 5 != 0) || random.chance(0.1 * share))
                                    : random.chance(share);
      if (wall) cells[{x, y}] = CellState::occupied;
    }
  }
  return *make_grid_map(cells);
}

class OptimalPlanners : public ::testing::TestWithParam<std::string> {};

/// All pairs of a map from some starts.
void expect_optimal_everywhere(const std::string& name, const GridMap& map, Random& random) {
  const FreeSpace space = *make_free_space(map);
  const auto planner = make_planner(name, space);
  ASSERT_TRUE(planner) << planner.error().message;
  const Reference reference(map, {}, {});
  Plan plan;
  for (int i = 0; i < 3; ++i) {
    const int start_x = random.between(0, map.width() - 1);
    const int start_y = random.between(0, map.height() - 1);
    const Cell start{start_x, start_y};
    if (!space.passable(start)) continue;
    const std::vector<double> costs = reference.costs_from(start);
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const double cost = costs[reference.number({x, y})];
        const Status status = (*planner)->plan(Query::between(start, {x, y}), plan);
        ASSERT_EQ(status == Status::found, cost < kInfinite);
        if (status != Status::found) continue;
        ASSERT_NEAR(plan.cost, cost, kEqualRelative * (1 + cost))
            << start.x << ',' << start.y << " to " << x << ',' << y;
        ASSERT_EQ(reference.fault(plan.path.cells(), start, {x, y}), "");
        ASSERT_NEAR(reference.cost_of(plan.path.cells()), cost, kEqualRelative * (1 + cost));
      }
    }
  }
}

void expect_optimal_on_nasty_maps(const std::string& planner, std::uint64_t seed, int maps,
                                  int longest_side) {
  Random random(seed);
  for (int i = 0; i < maps && !::testing::Test::HasFatalFailure(); ++i) {
    const int width = random.between(1, longest_side);
    const int height = random.between(1, longest_side);
    const GridMap map = nasty_map(random, width, height);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", map " + std::to_string(i) + "\n" +
                 drawing_of(map));
    expect_optimal_everywhere(planner, map, random);
  }
}

TEST_P(OptimalPlanners, AreOptimalOnNastyMaps) {
  expect_optimal_on_nasty_maps(GetParam(), 41, 400, 16);
}

/// With ./run test --all.
TEST_P(OptimalPlanners, AreOptimalOnNastyMapsInALongRun) {
  expect_optimal_on_nasty_maps(GetParam(), 43, 200000, 10);
}

TEST_P(OptimalPlanners, AreOptimalWhereWordsEnd) {
  Random random(42);
  for (int i = 0; i < 12 && !HasFatalFailure(); ++i) {
    const bool wide = random.chance(0.5);
    const int length = random.between(61, 67) + 64 * random.between(0, 1);
    const int other = random.between(2, 9);
    const GridMap map = nasty_map(random, wide ? length : other, wide ? other : length);
    SCOPED_TRACE("seed 42, map " + std::to_string(i) + "\n" + drawing_of(map));
    expect_optimal_everywhere(GetParam(), map, random);
  }
}

std::vector<std::string> optimal_planners() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    if (!info.capabilities.headings && info.capabilities.jumps &&
        info.guarantee == Guarantee::optimal) {
      names.push_back(info.name);
    }
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Registry, OptimalPlanners, ::testing::ValuesIn(optimal_planners()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
