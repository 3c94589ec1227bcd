// Plans, and fields of costs, which plan too.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "conformance/random_map.hpp"
#include "tests/testing/c_objects.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/c/boundary.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/search/search_metrics.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend::test {
namespace {

constexpr double kNoPath = std::numeric_limits<double>::infinity();

Owned<wend_field> field_of(wend_session* session, const wend_request& request) {
  return made_object<wend_field>([&](wend_field** out, wend_error* error) {
    return wend_session_field(session, &request, out, error);
  });
}

Refusal refused_field(wend_session* session, const wend_request* request) {
  return refusal_of<wend_field>([&](wend_field** field, wend_error* error) {
    return wend_session_field(session, request, field, error);
  });
}

TEST(CField, HasTheCostsOfTheCppInterfaceAndItsPaths) {
  int paths = 0;
  for (int seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map = random_map(random);
    const FreeSpace space = *make_free_space(map, {.outside = OutsidePolicy::free});
    const auto session = c_session(c_map(map).get());
    const Cell goal = random_cell(random, map.width(), map.height());
    const auto pose_in = [&](Cell cell) {
      const MapPoint point = map.frame().to_metres(centre_of(cell));
      return wend_pose{point.x, point.y, 0};
    };
    const wend_pose target = pose_in(goal);
    wend_request request = request_to(target);
    const bool four = random.chance(0.3);
    request.planner = four ? "bfs:connectivity=4" : "astar";
    const GridMoves moves{.connectivity = four ? Connectivity::four : Connectivity::eight};
    const auto expected = CostToGo::make(space, std::array{goal}, moves);
    if (!expected) {
      EXPECT_EQ(refused_field(session.get(), &request).status,
                c::status_of(expected.error().status));
      continue;
    }
    const auto field = field_of(session.get(), request);
    ASSERT_EQ(wend_field_width(field.get()), map.width());
    ASSERT_EQ(wend_field_height(field.get()), map.height());
    EXPECT_EQ(wend_field_expanded(field.get()), expected->metrics().expanded);
    std::size_t at = 0;
    for (const double cost : expected->costs().values()) {
      EXPECT_EQ(wend_field_costs(field.get())[at++], cost);
    }
    const Cell start = random_cell(random, map.width(), map.height());
    const wend_pose from = pose_in(start);
    EXPECT_EQ(wend_field_cost_at(field.get(), from.x, from.y), expected->cost(start));
    const auto path = expected->path_from(start);
    wend_plan* plan = nullptr;
    const wend_status status = wend_field_plan(field.get(), &from, &plan, nullptr);
    const Owned<wend_plan> owner(plan);
    ASSERT_EQ(status, path ? WEND_OK : c::status_of(path.error().status));
    if (!path) continue;
    ++paths;
    EXPECT_EQ(wend_plan_cost(plan), path->cost);
    EXPECT_EQ(wend_plan_bound(plan), 1);
    EXPECT_EQ(wend_plan_pose_count(plan), path->path.size());
  }
  EXPECT_GT(paths, 40) << "too few paths to say anything";
}

TEST(CField, OutlivesItsSessionAndIsKeptThere) {
  const wend_pose goal{3.5, 0.5, 0};
  const wend_request request = request_to(goal);
  auto session = c_session(open_c_map(4, 1).get());
  const auto first = field_of(session.get(), request);
  const auto second = field_of(session.get(), request);
  session.reset();
  EXPECT_EQ(wend_field_expanded(first.get()), 4U);
  EXPECT_EQ(wend_field_expanded(second.get()), 0U);
  for (const auto* const field : {first.get(), second.get()}) {
    EXPECT_EQ(wend_field_cost_at(field, 0.5, 0.5), 3);
    EXPECT_EQ(wend_field_cost_at(field, -0.5, 0.5), kNoPath);
    EXPECT_EQ(wend_field_cost_at(field, kAnyHeading, 0.5), kNoPath);
  }
}

TEST(CField, RefusesPlannersThatDoNotStepFromCellToCell) {
  const wend_pose goal{3.5, 3.5, 0};
  const auto session = c_session(open_c_map(9, 9).get());
  wend_request request = request_to(goal);
  for (const char* const planner : {"lattice", "theta_star"}) {
    request.planner = planner;
    EXPECT_EQ(refused_field(session.get(), &request).message,
              std::string(planner) + " does not step from cell to cell: it has no field");
  }
  request.planner = "nothing";
  EXPECT_EQ(refused_field(session.get(), &request).status, WEND_INVALID_OPTION);
}

TEST(CField, SaysWhatIsWrongWithItsGoals) {
  const auto session = c_session(open_c_map(4, 4).get());
  const wend_pose outside{9, 1, 0};
  wend_request request = request_to(outside);
  const auto refusal = refused_field(session.get(), &request);
  EXPECT_EQ(refusal.status, WEND_GOAL_OUTSIDE);
  EXPECT_EQ(refusal.message,
            "the goal (9,1) m, cell (9,1) is outside the map, which covers x from 0 to 4 m and y "
            "from 0 to 4 m");
  request.tolerance = 5.6;  // reaches the cells of the last column
  const auto field = field_of(session.get(), request);
  EXPECT_EQ(wend_field_cost_at(field.get(), 3.5, 1.5), 0);
  EXPECT_EQ(wend_field_cost_at(field.get(), 1.5, 1.5), 2);
  request.goal_count = 0;
  EXPECT_EQ(refused_field(session.get(), &request).status, WEND_INVALID_ARGUMENT);
  const wend_pose goal{1.5, 1.5, 0};
  request = request_to(goal);
  request.expansions = 2;
  EXPECT_EQ(refused_field(session.get(), &request).status, WEND_EXPANSION_LIMIT);
}

TEST(CField, SaysWhyThereIsNoPathFromAStart) {
  const GridMap map = [] {
    Grid<CellState> cells(5, 1, CellState::free);
    cells[{1, 0}] = CellState::occupied;
    return *make_grid_map(cells);
  }();
  const auto session = c_session(c_map(map).get());
  const wend_pose goal{4.5, 0.5, 0};
  const auto field = field_of(session.get(), request_to(goal));
  const auto refused_from = [&](const wend_pose* start) {
    return refusal_of<wend_plan>([&](wend_plan** plan, wend_error* error) {
      return wend_field_plan(field.get(), start, plan, error);
    });
  };
  const std::array<wend_pose, 4> starts{
      wend_pose{-1, 0.5, 0}, {1.5, 0.5, 0}, {0.5, 0.5, 0}, {kAnyHeading, 0.5, 0}};
  EXPECT_EQ(refused_from(&starts[0]).status, WEND_START_OUTSIDE);
  EXPECT_EQ(refused_from(&starts[1]).message,
            "the start (1.5,0.5) m, cell (1,0) is blocked: the cell is an obstacle");
  EXPECT_EQ(refused_from(&starts[2]).status, WEND_UNREACHABLE);
  EXPECT_EQ(refused_from(&starts[3]).status, WEND_INVALID_ARGUMENT);
  EXPECT_EQ(refused_from(nullptr).status, WEND_INVALID_ARGUMENT);
}

TEST(CField, BearsNullPointers) {
  const wend_pose pose{1.5, 1.5, 0};
  const wend_request request = request_to(pose);
  const auto session = c_session(open_c_map(4, 4).get());
  EXPECT_EQ(refused_field(nullptr, &request).message, "session is null");
  EXPECT_EQ(refused_field(session.get(), nullptr).message, "request is null");
  EXPECT_EQ(wend_session_field(session.get(), &request, nullptr, nullptr), WEND_INVALID_ARGUMENT);
  wend_plan* plan = nullptr;
  EXPECT_EQ(wend_field_plan(nullptr, &pose, &plan, nullptr), WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_field_plan(field_of(session.get(), request).get(), &pose, nullptr, nullptr),
            WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_field_width(nullptr), 0);
  EXPECT_EQ(wend_field_height(nullptr), 0);
  EXPECT_EQ(wend_field_costs(nullptr), nullptr);
  EXPECT_TRUE(std::isnan(wend_field_cost_at(nullptr, 0, 0)));
  EXPECT_EQ(wend_field_expanded(nullptr), 0U);
  wend_field_free(nullptr);
}

TEST(CPlan, HasTheMetricsOfTheCppInterface) {
  const auto session = c_session(open_c_map(9, 9).get());
  const wend_pose goal{7.5, 2.5, kAnyHeading};
  const wend_request request = request_to(goal);
  const auto plan = made_object<wend_plan>([&](wend_plan** out, wend_error* error) {
    return wend_session_plan(session.get(), &request, out, error);
  });
  const std::vector<Metric> path = metrics_of(PathMetrics{});
  ASSERT_EQ(wend_metric_count(), path.size() + metrics_of(SearchMetrics{}).size());
  double value = 0;
  for (std::size_t i = 0; i < wend_metric_count(); ++i) {
    EXPECT_EQ(wend_plan_metric(plan.get(), wend_metric_name(i), &value, nullptr), WEND_OK);
    if (i >= path.size()) continue;
    EXPECT_EQ(wend_metric_name(i), path[i].name);
    EXPECT_EQ(wend_metric_unit(i), metric_unit_name(path[i].unit));
    EXPECT_EQ(wend_metric_help(i), path[i].help);
  }
  const auto metric = [&](const char* name) {
    EXPECT_EQ(wend_plan_metric(plan.get(), name, &value, nullptr), WEND_OK);
    return value;
  };
  EXPECT_NEAR(metric("length"), wend_plan_length(plan.get()), 1e-12);
  EXPECT_EQ(metric("expanded"), static_cast<double>(wend_plan_expanded(plan.get())));
  EXPECT_EQ(metric("generated"), static_cast<double>(wend_plan_generated(plan.get())));
  EXPECT_GE(metric("max_frontier"), 1);
  EXPECT_GT(metric("turning"), 0);
  EXPECT_EQ(metric("smallest_turning_radius"), 0);
  wend_error error;
  EXPECT_EQ(wend_plan_metric(plan.get(), "lenght", &value, &error), WEND_INVALID_OPTION);
  EXPECT_THAT(error.message, testing::HasSubstr("did you mean 'length'"));
  EXPECT_EQ(wend_metric_name(wend_metric_count()), nullptr);
  EXPECT_EQ(wend_metric_unit(wend_metric_count()), nullptr);
  EXPECT_EQ(wend_metric_help(wend_metric_count()), nullptr);
  EXPECT_EQ(wend_plan_metric(nullptr, "length", &value, nullptr), WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_plan_metric(plan.get(), nullptr, &value, nullptr), WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_plan_metric(plan.get(), "length", nullptr, nullptr), WEND_INVALID_ARGUMENT);
}

TEST(CPlan, BearsNullPointers) {
  EXPECT_EQ(wend_plan_pose_count(nullptr), 0U);
  EXPECT_EQ(wend_plan_poses(nullptr), nullptr);
  EXPECT_TRUE(std::isnan(wend_plan_cost(nullptr)));
  EXPECT_TRUE(std::isnan(wend_plan_bound(nullptr)));
  EXPECT_TRUE(std::isnan(wend_plan_length(nullptr)));
  EXPECT_EQ(wend_plan_expanded(nullptr), 0U);
  EXPECT_EQ(wend_plan_generated(nullptr), 0U);
  EXPECT_TRUE(std::isnan(wend_plan_lead_out_length(nullptr)));
  EXPECT_EQ(wend_plan_lead_out_pose_count(nullptr), 0U);
  EXPECT_EQ(wend_plan_lead_out_reason(nullptr), nullptr);
  EXPECT_TRUE(std::isnan(wend_plan_remaining(nullptr)));
  EXPECT_EQ(wend_plan_gears(nullptr), nullptr);
  EXPECT_TRUE(std::isnan(wend_plan_start_shift(nullptr)));
  EXPECT_TRUE(std::isnan(wend_plan_goal_shift(nullptr)));
  wend_plan_free(nullptr);
}

}  // namespace
}  // namespace wend::test
