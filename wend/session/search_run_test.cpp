#include "wend/session/search_run.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/map/map_edit.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/session.hpp"
#include "wend/session/walled_room_test.hpp"

namespace wend {
namespace {

using test::across;
using test::walled_room;

constexpr int kWidth = 24;
constexpr int kHeight = 18;

GridMap random_map(Random& random) {
  Grid<CellState> cells(kWidth, kHeight, CellState::free);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (random.uniform() < 0.25) cells[{x, y}] = CellState::occupied;
    }
  }
  return *make_grid_map(cells,
                        {.resolution = 0.1, .origin = {-2, 1, 0}, .y_up = true, .metric = true});
}

/// Ends anywhere, sometimes in walls and off the map, with every leeway.
PlanRequest random_request(const std::string& planner, Random& random) {
  const auto chance = [&](double share) { return random.uniform() < share; };
  const auto between = [&](double least, double most) {
    return least + (most - least) * random.uniform();
  };
  const auto place = [&] {
    return MapPoint{between(-2.05, -2 + 0.1 * kWidth), between(1, 1 + 0.1 * kHeight)};
  };
  const MapPoint start = place();
  PlanRequest request{{start.x, start.y, between(-3, 3)}, {}, {planner}};
  if (planner == "hybrid_astar") request.planner.options = {{"turning_radius", "0.2"}};
  do {
    MapGoal& goal = request.goals.emplace_back(MapGoal{place()});
    if (chance(0.5)) goal.heading = between(-3, 3);
    if (chance(0.3)) goal.tolerance = between(0, 0.5);
    if (chance(0.3)) goal.heading_tolerance = between(0, 1);
  } while (chance(0.3));
  request.nearest = chance(0.4);
  request.closest = chance(0.3);
  if (chance(0.3)) request.escape = between(0, 0.5);
  if (chance(0.2)) request.limits.expansions = static_cast<std::uint64_t>(between(0, 200));
  request.explain = chance(0.5);
  return request;
}

using Answer = Expected<PlanAnswer, RequestFailure>;

void expect_same(const Answer& answer, const Answer& expected) {
  ASSERT_EQ(answer.has_value(), expected.has_value())
      << (answer ? expected.error().message : answer.error().message);
  if (!expected) {
    EXPECT_EQ(answer.error().status, expected.error().status);
    EXPECT_EQ(answer.error().message, expected.error().message);
    return;
  }
  EXPECT_EQ(answer->plan.path, expected->plan.path);
  EXPECT_EQ(answer->plan.cost, expected->plan.cost);
  EXPECT_EQ(answer->plan.bound, expected->plan.bound);
  EXPECT_EQ(answer->notes, expected->notes);
  EXPECT_EQ(answer->remaining, expected->remaining);
  EXPECT_EQ(answer->lead_out.has_value(), expected->lead_out.has_value());
  EXPECT_EQ(answer->start_shift(), expected->start_shift());
}

Answer answer_by(Session& session, const PlanRequest& request, bool in_steps) {
  auto run = session.begin(request);
  if (!run) return Unexpected<RequestFailure>(run.error());
  if (in_steps) {
    while (!run->step()) {
    }
  } else {
    run->run();
  }
  return run->finish();
}

class EveryPlannersRun : public testing::TestWithParam<std::string> {};

/// Sessions that are asked the same, one after the other: planners may remember what was asked.
TEST_P(EveryPlannersRun, AnswersAsPlanDoes) {
  Random random(7);
  const int maps = GetParam() == "hybrid_astar" ? 1 : 4;
  for (int map = 0; map < maps; ++map) {
    const GridMap cells = random_map(random);
    const FreeSpaceOptions robot{.footprint = Footprint::disc(map % 2 == 0 ? 0 : 0.07)};
    Session by_plan(cells, robot);
    Session by_run(cells, robot);
    Session by_steps(cells, robot);
    for (int query = 0; query < 8; ++query) {
      SCOPED_TRACE("map " + std::to_string(map) + ", query " + std::to_string(query));
      const PlanRequest request = random_request(GetParam(), random);
      const Answer expected = by_plan.plan(request);
      expect_same(answer_by(by_run, request, false), expected);
      expect_same(answer_by(by_steps, request, true), expected);
    }
  }
}

TEST_P(EveryPlannersRun, LeavesTheSessionUsableIfItIsDropped) {
  Session session(walled_room());
  PlanRequest request = across();
  request.planner.name = GetParam();
  const Answer expected = Session(walled_room()).plan(request);
  {
    auto run = session.begin(request);
    ASSERT_TRUE(run) << run.error().message;
    for (int i = 0; i < 3; ++i) run->step();
    auto another = session.begin(request);  // at the same time
    ASSERT_TRUE(another);
    another->step();
    run->step();
    *run = *std::move(another);
    run->step();
  }
  expect_same(session.plan(request), expected);
}

std::vector<std::string> planner_names() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) names.push_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(SearchRun, EveryPlannersRun, testing::ValuesIn(planner_names()),
                         [](const auto& name) { return name.param; });

struct ExpansionCount final : SearchObserver {
  void on_generate(const SearchEvent& /*event*/) override {}
  void on_relax(const SearchEvent& /*event*/) override {}
  void on_expand(const SearchEvent& /*event*/) override { ++count; }
  std::uint64_t count = 0;
};

TEST(SearchRun, ExpandsOneStateInAStep) {
  Session session(walled_room());
  ExpansionCount seen;
  PlanRequest request = across();
  request.observer = &seen;
  auto run = *session.begin(request);
  EXPECT_EQ(run.open_list(5).count, 0U);
  EXPECT_FALSE(run.restart());
  EXPECT_EQ(run.open_list(5).count, 1U);
  for (std::uint64_t i = 1; i <= 20; ++i) {
    EXPECT_FALSE(run.step());
    EXPECT_EQ(run.plan().metrics.expanded, i);
    EXPECT_EQ(seen.count, i);
  }
  EXPECT_FALSE(run.restart());
  EXPECT_EQ(run.plan().metrics.expanded, 0U);
  EXPECT_EQ(run.run(), Status::found);
  EXPECT_EQ(run.run(), Status::found);  // once
  const std::uint64_t expanded = run.plan().metrics.expanded;
  ExpansionCount again;
  run.repeat(again);
  EXPECT_EQ(again.count, expanded);
  EXPECT_EQ(seen.count, 20 + expanded);
  EXPECT_TRUE(run.finish());
}

TEST(SearchRun, KeepsItsViewWhileTheMapIsEdited) {
  Session session(walled_room());
  const Answer before = session.plan(across());
  auto run = *session.begin(across());
  run.step();
  const MapEdit wall{{50, 80}, Grid<CellState>(1, 20, CellState::occupied)};
  ASSERT_TRUE(session.edit(wall));
  expect_same(run.finish(), before);
  EXPECT_EQ(session.plan(across()).error().status, Status::unreachable);
}

TEST(SearchRun, CanBeCancelledBetweenSteps) {
  Session session(walled_room());
  std::atomic<bool> cancel = false;
  PlanRequest request = across();
  request.limits.cancel = &cancel;
  for (const bool in_steps : {false, true}) {
    cancel = false;
    auto run = *session.begin(request);
    if (in_steps) run.step();
    cancel = true;
    EXPECT_EQ(run.run(), Status::cancelled);
    EXPECT_EQ(run.finish().error().status, Status::cancelled);
  }
  cancel = false;
  auto run = *session.begin(request);
  run.step();
  run.cancel();
  EXPECT_EQ(run.step(), Status::cancelled);
  EXPECT_EQ(run.finish().error().status, Status::cancelled);
  EXPECT_TRUE(session.plan(request));
}

TEST(SearchRun, CountsItsLimitOnTimeFromItsBegin) {
  Session session(walled_room());
  double now = 0;
  PlanRequest request = across();
  request.limits.seconds = 10;
  request.limits.clock = [&] { return now += 1e-6; };  // no clock stands still
  auto run = *session.begin(request);
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(run.step());
  now = 11;
  EXPECT_EQ(run.run(), Status::time_limit);
  run.cancel();  // it is over
  EXPECT_EQ(run.finish().error().status, Status::time_limit);
  auto refined = across();
  refined.limits = request.limits;
  refined.refinement.smoother = SmootherChoice{};
  refined.refinement.simplify = Simplification{};
  now = 0;
  auto found = *session.begin(refined);
  EXPECT_EQ(found.run(), Status::found);
  now = 11;
  const auto answer = found.finish();
  ASSERT_TRUE(answer);
  ASSERT_TRUE(answer->fault);
  EXPECT_EQ(answer->fault->status, Status::time_limit);
  // Of a call that has begun before.
  now = 0;
  const Deadline deadline(request.limits);
  now = 11;
  auto late = session.begin(*session.view(), request, deadline);
  EXPECT_EQ(late ? late->run() : late.error().status, Status::time_limit);
}

TEST(SearchRun, EndsItsSolutionsWithTheAnswerOfPlan) {
  for (const std::string name : {"ara_star", "astar", "car", "lattice"}) {
    SCOPED_TRACE(name);
    Session session(walled_room());
    PlanRequest request = across();
    request.planner.name = name;
    if (name != "astar") request.planner.options = {{"initial_weight", "10"}};
    auto run = *session.begin(request);
    std::vector<PlanAnswer> answers;
    while (auto answer = run.next_solution()) answers.push_back(*std::move(answer));
    ASSERT_FALSE(answers.empty());
    EXPECT_EQ(run.planner().anytime(), name != "astar");
    EXPECT_EQ(answers.size() > 1, name != "astar");
    for (std::size_t i = 1; i < answers.size(); ++i) {
      EXPECT_LT(answers[i].plan.bound, answers[i - 1].plan.bound);
    }
    const Answer expected = session.plan(request);
    expect_same(answers.back(), expected);
    expect_same(run.finish(), expected);
  }
}

TEST(SearchRun, SaysWhyThereIsNoSolution) {
  Session session(walled_room());
  PlanRequest request = across();
  request.planner.name = "ara_star";
  request.goals.front().point.x = 3.05;  // in the wall
  request.explain = false;
  auto run = *session.begin(request);
  EXPECT_FALSE(run.next_solution());
  const Answer answer = run.finish();
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().status, Status::goal_blocked);
  request.explain = true;
  EXPECT_EQ(run.explain(), session.plan(request).error().message);
}

/// The same query in metres, and in the planner's own numbers.
TEST(SearchRun, TakesCellsAsTheyAre) {
  Session session(walled_room());
  PlanRequest in_cells{{10.5, 10.5, 0}, {{{90.5, 10.5}}}};
  in_cells.coordinates = MapUnits::cells;
  in_cells.goals.front().tolerance = 2;
  PlanRequest in_metres = across();
  in_metres.goals.front().tolerance = 0.2;
  expect_same(session.plan(in_cells), session.plan(in_metres));
  EXPECT_EQ(session.begin(in_cells)->query().start, (Pose{10.5, 10.5, 0}));
}

TEST(SearchRun, SpeaksOfEndsAsTheyWereTyped) {
  Session session(walled_room());
  PlanRequest request = across();
  request.goals.front().point.x = 3.05;  // in the wall
  EXPECT_NE(session.plan(request).error().message.find("(3.05,-1.95) m"), std::string::npos);
  request.start = {10.5, 10.5, 0};
  request.goals.front().point = {50.5, 10.5};
  request.coordinates = request.wording = MapUnits::cells;
  const std::string in_cells = session.plan(request).error().message;
  EXPECT_NE(in_cells.find("the goal (50,10) is blocked"), std::string::npos) << in_cells;
  EXPECT_EQ(in_cells.find(" m"), std::string::npos) << in_cells;
  request.texts = {"the dock", {"'table 3'"}};
  const std::string typed = session.plan(request).error().message;
  EXPECT_NE(typed.find("the goal 'table 3' is blocked"), std::string::npos) << typed;
}

}  // namespace
}  // namespace wend
