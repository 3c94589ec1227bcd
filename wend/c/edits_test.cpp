// Edits of costs, and planning again after edits.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "conformance/random_edit.hpp"
#include "conformance/random_map.hpp"
#include "tests/testing/c_objects.hpp"
#include "wend/c/objects.hpp"

namespace wend::test {
namespace {

/// Random multipliers for a random box, given to a session of each interface.
void edit_both_costs(Random& random, wend_session* c, Session& cpp) {
  const CellBox box = random_box_on(random, cpp.view()->space.map(), 8);
  std::vector<double> terrain(static_cast<std::size_t>(box.size()));
  for (double& multiplier : terrain) multiplier = 1 + 4 * random.uniform();
  ASSERT_TRUE(cpp.edit({.corner = box.begin, .terrain = {box.width(), box.height(), terrain}}));
  ASSERT_EQ(wend_session_edit_terrain(c, box.begin.x, box.begin.y, box.width(), box.height(),
                                      terrain.data(), terrain.size(), nullptr),
            WEND_OK);
}

TEST(CEdits, ChangeCostsLikeASession) {
  for (std::uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const GridMap map = random_map(random);
    Session cpp(map, {.outside = OutsidePolicy::free});
    const auto c = c_session(c_map(map).get());
    for (int i = 0; i < 3; ++i) {
      edit_both_costs(random, c.get(), cpp);
      const FreeSpace expected = cpp.view()->space;
      const FreeSpace space = c->session.view()->space;
      for (const Cell cell : every_cell(expected)) {
        ASSERT_EQ(space.costs().steps(cell), expected.costs().steps(cell));
        ASSERT_EQ(space.map().state(cell), map.state(cell));
      }
    }
  }
}

TEST(CEdits, RefuseCostsThatDoNotFit) {
  const auto session = c_session(open_c_map(5, 4).get());
  const std::array<double, 4> terrain{1, 2, 3, 4};
  const std::array<double, 1> cheap{0.5};
  const std::array<double, 1> invalid{NAN};
  const auto message = [&](int x, int y, int width, int height, const double* multipliers,
                           std::size_t count) {
    wend_error error;
    EXPECT_NE(
        wend_session_edit_terrain(session.get(), x, y, width, height, multipliers, count, &error),
        WEND_OK);
    return std::string(error.message);
  };
  EXPECT_EQ(message(4, 0, 2, 2, terrain.data(), 4),
            "cell (5,1) of the edit is not on the map of 5 x 4 cells");
  EXPECT_EQ(message(0, 0, 3, 2, terrain.data(), 4),
            "there are 4 multipliers for a box of 3 x 2 cells");
  EXPECT_EQ(message(0, 0, 1, 1, nullptr, 1), "terrain is null");
  EXPECT_EQ(message(0, 0, 1, 1, cheap.data(), 1),
            "the terrain of cell (0,0) of the edit is 0.5: a multiplier is at least 1 and finite");
  EXPECT_EQ(message(0, 0, 1, 1, invalid.data(), 1),
            "the terrain of cell (0,0) of the edit is nan: a multiplier is at least 1 and finite");
  EXPECT_EQ(wend_session_edit_terrain(nullptr, 0, 0, 2, 2, terrain.data(), 4, nullptr),
            WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_session_edit_terrain(session.get(), 0, 0, 2, 2, terrain.data(), 4, nullptr),
            WEND_OK);
}

Owned<wend_plan> replanned(wend_session* session, const wend_request& request) {
  return made_object<wend_plan>([&](wend_plan** out, wend_error* error) {
    return wend_session_replan(session, &request, out, error);
  });
}

/// Above a wall there is a way; then a door opens in it.
TEST(CEdits, LeaveAPathThatIsKept) {
  for (const char* const planner : {"astar", "any_angle", "hybrid_astar:turning_radius=1"}) {
    Grid<CellState> states(30, 20, CellState::free);
    for (int y = 0; y < 16; ++y) states[{15, y}] = CellState::occupied;
    const auto session = c_session(c_map(*make_grid_map(states)).get());
    const wend_pose goal{25.5, 5.5, kAnyHeading};
    wend_request request = request_to(goal, {5.5, 5.5, 0});
    request.planner = planner;
    const auto first = replanned(session.get(), request);
    EXPECT_EQ(wend_plan_kept(first.get()), 0);
    const std::vector<std::uint8_t> free(8, 0);
    ASSERT_EQ(wend_session_edit(session.get(), 15, 2, 1, 8, free.data(), free.size(), nullptr),
              WEND_OK);
    request.keep = 0.9;
    const auto kept = replanned(session.get(), request);
    EXPECT_EQ(wend_plan_kept(kept.get()), 1) << planner;
    EXPECT_NEAR(wend_plan_cost(kept.get()), wend_plan_cost(first.get()), 1e-6) << planner;
    request.keep = 0.01;
    const auto taken = replanned(session.get(), request);
    EXPECT_EQ(wend_plan_kept(taken.get()), 0) << planner;
    EXPECT_LT(wend_plan_cost(taken.get()), 0.99 * wend_plan_cost(first.get())) << planner;
    wend_plan* plan = nullptr;
    for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
      request.keep = wrong;
      EXPECT_EQ(wend_session_replan(session.get(), &request, &plan, nullptr),
                WEND_INVALID_ARGUMENT);
    }
  }
}

/// A wall with a gap at its top.
TEST(CEdits, AreFollowedByPlanningAgain) {
  Grid<CellState> states(30, 20, CellState::free);
  for (int y = 0; y < 18; ++y) states[{15, y}] = CellState::occupied;
  const auto session = c_session(c_map(*make_grid_map(states)).get());
  const wend_pose goal{25.5, 2.5, kAnyHeading};
  wend_request request = request_to(goal, {5.5, 2.5, 0});

  const auto first = replanned(session.get(), request);
  EXPECT_GT(wend_plan_expanded(first.get()), 0U);
  EXPECT_EQ(wend_plan_expanded(replanned(session.get(), request).get()), 0U) << "it stays";

  // Off the path: the path stays the cheapest, from the robot on.
  const double dear = 7;
  ASSERT_EQ(wend_session_edit_terrain(session.get(), 0, 0, 1, 1, &dear, 1, nullptr), WEND_OK);
  request.start = wend_plan_poses(first.get())[3];
  const auto planned_anew = [&] {
    return made_object<wend_plan>([&](wend_plan** out, wend_error* error) {
      return wend_session_plan(session.get(), &request, out, error);
    });
  };
  const auto rest = replanned(session.get(), request);
  EXPECT_NEAR(wend_plan_cost(rest.get()), wend_plan_cost(planned_anew().get()), 1e-9);

  // A door on the way: a shorter path.
  const std::uint8_t open = 0;
  ASSERT_EQ(wend_session_edit(session.get(), 15, 2, 1, 1, &open, 1, nullptr), WEND_OK);
  const auto through = replanned(session.get(), request);
  EXPECT_LT(wend_plan_cost(through.get()), wend_plan_cost(rest.get()));
  EXPECT_NEAR(wend_plan_cost(through.get()), wend_plan_cost(planned_anew().get()), 1e-9);

  // The moves are those of the planner that was asked for.
  request.planner = "bfs:connectivity=4";
  const double straight = wend_plan_cost(replanned(session.get(), request).get());
  EXPECT_EQ(straight, std::floor(straight));
}

TEST(CEdits, AndRequestsToPlanAgainAreRefusedLikeThoseToPlan) {
  const auto session = c_session(open_c_map(4, 4).get());
  const wend_pose goal{3.5, 3.5, kAnyHeading};
  wend_request request = request_to(goal);
  const auto status = [&](wend_session* asked, const wend_request* with) {
    return refusal_of<wend_plan>([&](wend_plan** plan, wend_error* error) {
             return wend_session_replan(asked, with, plan, error);
           })
        .status;
  };
  EXPECT_EQ(status(nullptr, &request), WEND_INVALID_ARGUMENT);
  EXPECT_EQ(status(session.get(), nullptr), WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_session_replan(session.get(), &request, nullptr, nullptr), WEND_INVALID_ARGUMENT);
  request.planner = "no_planner";
  EXPECT_EQ(status(session.get(), &request), WEND_INVALID_OPTION);
  request.planner = "astar";
  const std::array<std::uint8_t, 4> wall{1, 1, 1, 1};
  ASSERT_EQ(wend_session_edit(session.get(), 1, 0, 1, 4, wall.data(), 4, nullptr), WEND_OK);
  EXPECT_EQ(status(session.get(), &request), WEND_UNREACHABLE);
}

}  // namespace
}  // namespace wend::test
