// Sessions whose map is edited.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/session/session.hpp"
#include "wend/session/walled_room_test.hpp"

namespace wend {
namespace {

using test::across;
using test::walled_room;

/// Closes the way at the top of walled_room().
MapEdit closing() {
  return {.corner = {50, 80}, .states = Grid<CellState>(1, 20, CellState::occupied)};
}

MapEdit opening() { return {.corner = {50, 30}, .states = Grid<CellState>(1, 3, CellState::free)}; }

TEST(SessionEdit, ChangesWhatLaterPlansSee) {
  Session session(walled_room());
  ASSERT_TRUE(session.plan(across()));
  const auto before = session.view();
  const auto closed = session.edit(closing());
  ASSERT_TRUE(closed) << closed.error().message;
  EXPECT_EQ(closed->boxes, (std::vector<CellBox>{{{50, 80}, {51, 100}}}));
  EXPECT_EQ(session.plan(across()).error().status, Status::unreachable);
  EXPECT_TRUE(session.plan(*before, across())) << "an old view keeps its map";
  ASSERT_TRUE(session.edit(opening()));
  const auto answer = session.plan(across());
  ASSERT_TRUE(answer) << answer.error().message;
  Session fresh(session.view()->space.map());
  EXPECT_EQ(answer->plan.path, fresh.plan(across())->plan.path);
  EXPECT_GT(session.view()->version, before->version);
}

TEST(SessionEdit, AnswersLikeANewSessionWhateverThePlanner) {
  for (const PlannerInfo& info : planners()) {
    if (info.index_support || info.name == "random_walk") continue;
    SCOPED_TRACE(info.name);
    const FreeSpaceOptions robot{.footprint = Footprint::disc(0.15)};
    Session session(walled_room(), robot);
    PlanRequest request = across();
    request.planner = {info.name};
    for (const MapEdit& edit : {opening(), closing()}) {
      session.plan(request);
      ASSERT_TRUE(session.edit(edit));
      const auto answer = session.plan(request);
      const auto expected = Session(session.view()->space.map(), robot).plan(request);
      ASSERT_EQ(answer.has_value(), expected.has_value());
      if (!answer) {
        EXPECT_EQ(answer.error().status, expected.error().status);
      } else {
        EXPECT_EQ(answer->plan.path, expected->plan.path);
        EXPECT_EQ(answer->plan.cost, expected->plan.cost);
      }
    }
  }
}

TEST(SessionEdit, IsDoneInPlaceAndKeepsPlanners) {
  Session session(walled_room(), {.footprint = Footprint::disc(0.2)});
  const BitGrid* const passable = &session.view()->space.passable();
  const Planner* const planner = &**session.planner({"astar"});
  ASSERT_TRUE(session.edit(opening()));
  EXPECT_EQ(&session.view()->space.passable(), passable);
  const auto kept = session.planner({"astar"});
  EXPECT_EQ(&**kept, planner);
  EXPECT_EQ(&(*kept)->free_space().passable(), passable);
  ASSERT_TRUE(session.edit(closing())) << "the planner in use keeps its space";
  EXPECT_NE(&session.view()->space.passable(), passable);
  EXPECT_TRUE((*kept)->free_space().passable({50, 90}));
}

TEST(SessionEdit, LeavesAnIndexThatDoesNotMatch) {
  Session session(walled_room());
  PlanRequest request = across();
  request.planner = {"hub_labels"};
  ASSERT_TRUE(session.build_index("hub_labels"));
  ASSERT_TRUE(session.plan(request));
  ASSERT_TRUE(session.edit(opening()));
  const auto refused = session.plan(request);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().status, Status::index_mismatch);
  EXPECT_NE(refused.error().message.find("index does not match"), std::string::npos)
      << refused.error().message;
  ASSERT_TRUE(session.build_index("hub_labels"));
  EXPECT_TRUE(session.plan(request));
}

TEST(SessionEdit, KeepsAnIndexWhosePassableCellsAreAsTheyWere) {
  Session session(walled_room());
  PlanRequest request = across();
  request.planner = {"hub_labels"};
  ASSERT_TRUE(session.plan(request)) << "the planner builds an index itself";
  ASSERT_TRUE(session.edit(opening()));
  EXPECT_EQ(session.plan(request).error().status, Status::index_mismatch)
      << "an edit does not start a long build";
  ASSERT_TRUE(
      session.edit({.corner = {50, 30}, .states = Grid<CellState>(1, 3, CellState::occupied)}));
  EXPECT_TRUE(session.plan(request)) << "the map is what it was";
}

TEST(SessionEdit, IsRefusedWithoutAMapAndOutsideOfIt) {
  Session session;
  EXPECT_EQ(session.edit(closing()).error().status, Status::invalid_map);
  session.set_map(walled_room());
  const auto version = session.view()->version;
  const auto refused = session.edit({.corner = {99, 0}, .states = Grid<CellState>(2, 1)});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().status, Status::invalid_map);
  EXPECT_EQ(refused.error().message,
            "cell (100,0) of the edit is not on the map of 100 x 100 cells");
  EXPECT_EQ(session.view()->version, version);
  EXPECT_TRUE(session.plan(across()));
}

TEST(SessionEdit, ForgetsTheFieldOfCosts) {
  Session session(walled_room());
  const std::vector<Cell> goals{{90, 10}};
  const auto before = session.cost_to_go(*session.view(), goals);
  ASSERT_TRUE(session.edit(opening()));
  const auto after = session.cost_to_go(*session.view(), goals);
  ASSERT_TRUE(before && after);
  EXPECT_LT(after->costs->cost({10, 10}), before->costs->cost({10, 10}));
}

/// The field's own clock plans and edits, in another thread, while the field is being made: it goes on only when both
/// are done.
TEST(SessionEdit, NeitherEditNorPlanWaitsForAField) {
  Session session(walled_room());
  const auto view = session.view();
  int calls = 0;
  Limits limits;
  limits.clock = [&] {
    if (calls++ == 1) {
      std::thread other([&] {
        EXPECT_TRUE(session.edit(opening()));
        EXPECT_TRUE(session.plan(across()));
        EXPECT_TRUE(session.cost_to_go(*session.view(), {{80, 10}}));
      });
      other.join();
    }
    return 0.0;
  };
  const auto field = session.cost_to_go(*view, {{90, 10}}, {}, limits);
  ASSERT_TRUE(field);
  EXPECT_GT(calls, 1);
  const auto unedited = CostToGo::make(view->space, std::vector<Cell>{{90, 10}}, GridMoves{});
  ASSERT_TRUE(unedited);
  EXPECT_EQ(field->costs->cost({10, 10}), unedited->cost({10, 10})) << "it is that of the old view";
}

/// Both ask for the same field; whoever is second gets what the first made.
TEST(SessionEdit, OneFieldIsMadeForAllWhoAskForIt) {
  Session session(walled_room());
  const auto view = session.view();
  std::thread second;
  std::shared_ptr<const CostToGo> theirs;
  SearchMetrics their_work{1, 1, 1};
  Limits limits;
  limits.clock = [&] {
    if (!second.joinable()) {
      second = std::thread([&] {
        const auto field = session.cost_to_go(*view, {{90, 10}});
        if (!field) return;
        theirs = field->costs;
        their_work = field->metrics;
      });
    }
    return 0.0;
  };
  const auto field = session.cost_to_go(*view, {{90, 10}}, {}, limits);
  second.join();
  ASSERT_TRUE(field);
  EXPECT_EQ(theirs, field->costs);
  EXPECT_EQ(their_work.expanded, 0U);
}

TEST(SessionEdit, IsReplannedWithWhatWasFoundBefore) {
  Session session(walled_room());
  const auto first = session.replan(across());
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_GT(first->plan.metrics.expanded, 0U);

  // Far from the path: it stays the cheapest, from the robot on.
  ASSERT_TRUE(
      session.edit({.corner = {2, 60}, .states = Grid<CellState>(3, 3, CellState::occupied)}));
  PlanRequest on_the_way = across();
  on_the_way.start = first->poses()[5];
  const auto kept = session.replan(on_the_way);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->plan.metrics.expanded, 0U);
  EXPECT_EQ(kept->plan.path.size() + 5, first->plan.path.size());

  // A door in the wall: a cheaper path.
  ASSERT_TRUE(session.edit({.corner = {50, 20}, .states = Grid<CellState>(1, 2, CellState::free)}));
  const auto shorter = session.replan(on_the_way);
  ASSERT_TRUE(shorter);
  EXPECT_GT(shorter->plan.metrics.expanded, 0U);
  EXPECT_NEAR(shorter->plan.cost, session.plan(on_the_way)->plan.cost, 1e-9);
  EXPECT_LT(shorter->plan.cost, kept->plan.cost);

  // The moves are those of the planner that was asked for.
  on_the_way.planner = {"bfs", {{"connectivity", "4"}}};
  const auto straight = session.replan(on_the_way);
  ASSERT_TRUE(straight) << straight.error().message;
  EXPECT_EQ(straight->plan.cost, std::floor(straight->plan.cost));
  on_the_way.planner = {"no_planner"};
  EXPECT_EQ(session.replan(on_the_way).error().status, Status::invalid_option);
}

TEST(SessionEdit, ThatIsStoppedChangesNothing) {
  constexpr int kSide = 600;
  const auto map = *make_grid_map(Grid<CellState>(kSide, kSide, CellState::free));
  const std::atomic<bool> cancelled = true;
  Limits limits;
  limits.cancel = &cancelled;
  const MapEdit wall{.corner = {300, 0}, .states = Grid<CellState>(1, kSide, CellState::occupied)};
  const MapEdit all{.states = Grid<CellState>(kSide, kSide, CellState::unknown)};
  // One that needs the distances of all cells is made anew, and so is one of which many cells change.
  const FreeSpaceOptions far{.footprint = Footprint::disc(1), .clearance_distance = 100};
  const FreeSpaceOptions near{.footprint = Footprint::disc(1)};
  for (const auto& [robot, edit] : {std::pair(far, wall), std::pair(near, all)}) {
    Session session(map, robot);
    const PlanRequest request{{50.5, 50.5, 0}, {{{550.5, 50.5}}}};
    const auto before = session.plan(request);
    ASSERT_TRUE(before) << before.error().message;
    const std::uint64_t version = session.view()->version;
    const auto stopped = session.edit(edit, Deadline(limits));
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().status, Status::cancelled);
    EXPECT_EQ(session.view()->version, version);
    EXPECT_EQ(session.view()->space.passable(), before->space.passable());
    EXPECT_EQ(session.plan(request)->plan.path, before->plan.path);
    ASSERT_TRUE(session.edit(edit));
    EXPECT_FALSE(session.plan(request));
  }
}

TEST(SessionEdit, OfManyCellsIsTheSameWithADeadline) {
  const auto map = *make_grid_map(Grid<CellState>(600, 600, CellState::free));
  Random random(3);
  MapEdit edit{.states = Grid<CellState>(600, 600, CellState::free)};
  for (int i = 0; i < 3000; ++i) {
    edit.states[{static_cast<int>(random.below(600)), static_cast<int>(random.below(600))}] =
        CellState::occupied;
  }
  const std::atomic<bool> never = false;
  Limits limits;
  limits.cancel = &never;
  for (const double radius : {0.0, 2.5}) {
    const FreeSpaceOptions robot{.footprint = Footprint::disc(radius), .clearance_distance = 3};
    Session repaired(map, robot);
    Session made(map, robot);
    ASSERT_TRUE(repaired.edit(edit));
    ASSERT_TRUE(made.edit(edit, Deadline(limits)));
    EXPECT_EQ(made.view()->space.passable(), repaired.view()->space.passable());
    EXPECT_EQ(made.view()->space.options().outside, repaired.view()->space.options().outside);
  }
}

TEST(SessionEdit, IsReplannedOnTheViewThatIsGiven) {
  Session session(walled_room());
  const auto before = session.view();
  const auto first = session.replan(*before, across());
  ASSERT_TRUE(first) << first.error().message;
  const auto kept = session.replan(*before, across());
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->plan.metrics.expanded, 0U);
  EXPECT_EQ(kept->plan.path, first->plan.path);

  ASSERT_TRUE(session.edit(closing()));
  EXPECT_EQ(session.replan(*session.view(), across()).error().status, Status::unreachable);
  const auto old = session.replan(*before, across());
  ASSERT_TRUE(old) << "an old view keeps its map: " << old.error().message;
  EXPECT_EQ(old->plan.path, first->plan.path);

  // Planning on an old view does not disturb what serves the present one.
  ASSERT_TRUE(session.edit(opening()));
  const auto through = session.replan(*session.view(), across());
  ASSERT_TRUE(through);
  EXPECT_LT(through->plan.cost, first->plan.cost);
  ASSERT_TRUE(session.replan(*before, across()));
  const auto again = session.replan(*session.view(), across());
  ASSERT_TRUE(again);
  EXPECT_EQ(again->plan.metrics.expanded, 0U);
  EXPECT_EQ(again->plan.path, through->plan.path);
}

}  // namespace
}  // namespace wend
