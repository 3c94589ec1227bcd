#include "wend/session/session.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/base/random.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/session/nearest_ends.hpp"
#include "wend/session/walled_room_test.hpp"

namespace wend {
namespace {

using test::across;
using test::walled_room;

double number_between(Random& random, double least, double greatest) {
  return least + (greatest - least) * random.uniform();
}

TEST(Session, PlansInMetresAsThePlannerDoesInCells) {
  Session session(walled_room());
  const auto answer = session.plan(across());
  ASSERT_TRUE(answer) << answer.error().message;
  const FreeSpace space = *make_free_space(walled_room());
  const auto plan = (*make_planner("astar", space))->plan(Query::between({10, 10}, {90, 10}));
  ASSERT_TRUE(plan);
  EXPECT_EQ(answer->plan.path, plan->path);
  EXPECT_EQ(answer->plan.cost, plan->cost);
  const std::vector<MapPose> poses = answer->poses();
  EXPECT_NEAR(poses.front().x, -0.95, 1e-9);
  EXPECT_NEAR(poses.back().x, 7.05, 1e-9);
  EXPECT_NEAR(poses.back().y, -1.95, 1e-9);
  EXPECT_FALSE(answer->refined || answer->trajectory || answer->fault);
}

TEST(Session, HasNoAnswersWithoutAMap) {
  Session session;
  EXPECT_EQ(session.plan(across()).error().status, Status::invalid_map);
  EXPECT_EQ(session.nearest({}).error().status, Status::invalid_map);
  EXPECT_EQ(session.planner({"astar"}).error().status, Status::invalid_map);
  session.set_map(walled_room());
  EXPECT_TRUE(session.plan(across()));
  session.clear_map("the sensor is off");
  EXPECT_EQ(session.plan(across()).error().message, "the sensor is off");
}

TEST(Session, RefusesWhatCannotBePlanned) {
  Session session(walled_room());
  const auto status_of = [&](const PlanRequest& request) {
    const auto answer = session.plan(request);
    return answer ? Status::found : answer.error().status;
  };
  PlanRequest request = across();
  request.goals.clear();
  EXPECT_EQ(status_of(request), Status::unsupported_query);
  request = across();
  request.planner.name = "astr";
  EXPECT_EQ(status_of(request), Status::invalid_option);
  request = across();
  request.start.x = std::nan("");
  EXPECT_EQ(status_of(request), Status::start_outside);
  request = across();
  request.goals.front().point.y = 1e300;
  EXPECT_EQ(status_of(request), Status::goal_outside);
  request = across();
  request.limits.expansions = 3;
  EXPECT_EQ(status_of(request), Status::expansion_limit);
  session.set_robot({.footprint = Footprint::disc(-1)});
  EXPECT_EQ(status_of(across()), Status::invalid_option);
  session.set_robot({.footprint = Footprint::disc(0.2)});
  EXPECT_EQ(status_of(across()), Status::found);
}

TEST(Session, PlansForTheRobotOfTheMoment) {
  Session session(walled_room());
  const double of_a_point = session.plan(across())->plan.cost;
  session.set_robot({.footprint = Footprint::disc(0.5)});
  EXPECT_GT(session.plan(across())->plan.cost, of_a_point);
  session.set_robot({.footprint = Footprint::disc(1.5)});
  const auto too_large = session.plan(across());
  ASSERT_FALSE(too_large);
  EXPECT_NE(too_large.error().message.find("1.5 m"), std::string::npos)
      << too_large.error().message;
}

TEST(Session, KeepsAViewAsItWas) {
  Session session(walled_room());
  const auto view = session.view();
  ASSERT_TRUE(view);
  session.clear_map("gone");
  EXPECT_TRUE(session.plan(*view, across()));
  EXPECT_FALSE(session.plan(across()));
}

TEST(Session, ExplainsInTheWordsOfItsFrontEnd) {
  Grid<CellState> cells(20, 5, CellState::free);
  for (int y = 0; y < 5; ++y) cells[{10, y}] = CellState::unknown;
  const PlanRequest request{.start = {1.5, 1.5, 0}, .goals = {{{18.5, 1.5}}}};
  const auto message = [&](const Hints& hints) {
    Session session(*make_grid_map(cells), {}, {.hints = hints});
    return session.plan(request).error().message;
  };
  const std::string plain = message({});
  EXPECT_NE(plain.find("A path exists with unknown cells free"), std::string::npos) << plain;
  EXPECT_EQ(plain.find('('), plain.find("(1,1)")) << plain;
  const std::string hinted = message({.unknown_free = "unknown='free'"});
  EXPECT_NE(hinted.find("unknown cells free (unknown='free')"), std::string::npos) << hinted;
}

TEST(Session, MovesBlockedEndsIfAsked) {
  Session session(walled_room());
  PlanRequest request = across();
  request.start.x = 3.05;  // in the wall
  EXPECT_EQ(session.plan(request).error().status, Status::start_blocked);
  request.nearest = true;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  ASSERT_EQ(answer->notes.size(), 1U);
  EXPECT_NE(answer->notes.front().find("planning from"), std::string::npos);
  EXPECT_NEAR(answer->poses().front().x, 2.95, 1e-9);
}

TEST(Session, SaysThatAPlannerOnCellsTakesTheDiscAroundAPolygon) {
  Session session(walled_room(), {.footprint = *parse_footprint("rect:0.2x0.1,0.1")});
  PlanRequest request = across();
  request.explain = false;
  const auto notes_of = [&](const char* planner) {
    request.planner = PlannerSpec{planner};
    const auto answer = session.plan(request);
    EXPECT_TRUE(answer) << planner << ": " << answer.error().message;
    return answer ? answer->notes : std::vector<std::string>();
  };
  const auto notes = notes_of("astar");
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes.front().find("the robot is planned as the disc around its base point"),
            std::string::npos)
      << notes.front();
  EXPECT_TRUE(notes_of("hybrid_astar").empty());
  session.set_robot({.footprint = Footprint::disc(0.05)});
  EXPECT_TRUE(notes_of("astar").empty());
}

TEST(Session, MovesEachOfSeveralBlockedGoals) {
  Session session(walled_room());
  PlanRequest request = across();
  request.goals = {{{3.05, -2.5}}, {{3.05, 0}}, {{50, 50}}};  // in the wall, or outside
  EXPECT_EQ(session.plan(request).error().status, Status::goal_blocked);
  request.nearest = true;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(answer->notes.size(), 2U);
  EXPECT_NEAR(answer->poses().back().x, 2.95, 1e-9);
}

TEST(Session, BeginsAndEndsWhereItWasAskedTo) {
  Session session(walled_room());
  PlanRequest request = across();
  request.start.x += 0.03;
  request.goals.front().point.y -= 0.04;
  const auto centres = session.plan(across());
  ASSERT_TRUE(centres) << centres.error().message;
  for (const std::string name : {"astar", "bfs", "jps", "theta_star", "any_angle", "replanner"}) {
    SCOPED_TRACE(name);
    request.planner.name = name;
    for (const bool replan : {false, true}) {
      const auto answer = replan ? session.replan(request) : session.plan(request);
      ASSERT_TRUE(answer) << answer.error().message;
      const MapPose first = answer->poses().front();
      const MapPose last = answer->poses().back();
      EXPECT_NEAR(first.x, request.start.x, 1e-12);
      EXPECT_NEAR(first.y, request.start.y, 1e-12);
      EXPECT_NEAR(last.x, request.goals.front().point.x, 1e-12);
      EXPECT_NEAR(last.y, request.goals.front().point.y, 1e-12);
      EXPECT_NEAR(answer->start_shift(), 0, 1e-12);
      EXPECT_NEAR(answer->goal_shift(), 0, 1e-12);
    }
  }
}

/// A disc that only fits in the middle of a corridor.
TEST(Session, SaysHowFarTheEndsMoved) {
  Grid<CellState> cells(5, 3, CellState::occupied);
  for (int x = 0; x < 5; ++x) cells[{x, 1}] = CellState::free;
  Session session(*make_grid_map(cells, {.resolution = 0.5, .metric = true}),
                  {.footprint = Footprint::disc(0.25), .outside = OutsidePolicy::free});
  PlanRequest request{{0.75, 0.9, 0}, {{{1.8, 0.75}}}};
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_NEAR(answer->poses().front().y, 0.75, 1e-12);
  EXPECT_NEAR(answer->start_shift(), 0.15, 1e-12);
  EXPECT_NEAR(answer->poses().back().x, 1.8, 1e-12) << "along the corridor it fits";
  EXPECT_NEAR(answer->goal_shift(), 0, 1e-12);
}

TEST(Session, TakesEndsForCellsWhereAMapHasNoMetres) {
  Session session(test::drawn_map("....#.."));
  PlanRequest request{{0, 0, 0}, {{{5, 0}}}};
  request.closest = true;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(answer->remaining, 2);
  EXPECT_EQ(answer->start_shift(), 0);
  EXPECT_EQ(answer->goal_shift(), 2);
}

class Expansions final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& /*event*/) override {}
  void on_expand(const SearchEvent& /*event*/) override { ++count; }
  void on_relax(const SearchEvent& /*event*/) override {}

  std::uint64_t count = 0;
};

/// Whether the goal is reached, replaced by the closest place, or there is no path.
TEST(Session, ShowsAnObserverTheSearchThatAnswersOnly) {
  for (const std::string name :
       {"astar", "dijkstra", "theta_star", "car", "lattice", "hybrid_astar"}) {
    for (const bool walled_in : {false, true}) {
      for (const bool closest : {false, true}) {
        SCOPED_TRACE(name + (walled_in ? ", walled in" : "") + (closest ? ", closest" : ""));
        Session session(test::drawn_map(walled_in ? "............\n"
                                                    "............\n"
                                                    ".......#####\n"
                                                    ".......#...#\n"
                                                    ".......#...#\n"
                                                    ".......#####\n"
                                                  : "............\n"
                                                    "............\n"
                                                    "............\n"
                                                    "............\n"
                                                    "............\n"
                                                    "............\n"));
        Expansions expansions;
        PlanRequest request{{2, 3, 0}, {{{9, 4}}}, {name}};
        if (name == "hybrid_astar") request.planner.options = {{"turning_radius", "1"}};
        request.closest = closest;
        request.observer = &expansions;
        const auto answer = session.plan(request);
        ASSERT_EQ(answer.has_value(), !walled_in || closest);
        const SearchMetrics& metrics = answer ? answer->plan.metrics : answer.error().metrics;
        EXPECT_EQ(expansions.count, metrics.expanded);
        EXPECT_EQ(answer.has_value() && answer->remaining.value_or(0) > 0, walled_in && closest);
      }
    }
  }
}

/// hybrid_astar looks for places in the middles of cells; the closest one is where the way out ends.
TEST(Session, StaysWhereAWayOutEndsIfNoPlaceIsCloser) {
  Session session(test::drawn_map("....................\n"
                                  "....................\n"
                                  "....................\n"
                                  "............######..\n"
                                  "............#....#..\n"
                                  "............#....#..\n"
                                  "............######..\n"
                                  "....................\n"
                                  "....................\n"),
                  {.footprint = Footprint::disc(0.8)});
  PlanRequest request{{14.5, 2.5, 0}, {{{14.5, 4.5}}}, {"hybrid_astar"}};
  request.escape = 4;
  request.closest = true;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  ASSERT_TRUE(answer->lead_out);
  ASSERT_TRUE(answer->remaining);
  EXPECT_LT(*answer->remaining, 3);
}

TEST(Session, EndsWithinATolerance) {
  Session session(walled_room());
  PlanRequest request = across();
  request.goals = {{.point = {3.05, -1.95}, .tolerance = 0.5}};  // in the wall
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_NEAR(answer->poses().back().x, 2.55, 1e-9);
  EXPECT_NEAR(answer->plan.cost, 35, 1e-9);
  request.from_field = true;
  const auto from_field = session.plan(request);
  ASSERT_TRUE(from_field) << from_field.error().message;
  EXPECT_NEAR(from_field->plan.cost, 35, 1e-9);
  request.goals.front().tolerance = 0.05;
  for (const bool field : {false, true}) {
    request.from_field = field;
    const auto blocked = session.plan(request);
    ASSERT_FALSE(blocked);
    EXPECT_EQ(blocked.error().status, Status::goal_blocked);
    EXPECT_NE(blocked.error().message.find("fits nowhere within its tolerance of 0.05 m"),
              std::string::npos)
        << blocked.error().message;
  }
  request.from_field = false;
  request.planner.name = "car";
  request.goals = {
      {.point = {-0.95, 0.05}, .heading = 0, .tolerance = 0.2, .heading_tolerance = 4}};
  EXPECT_LT(session.plan(request)->plan.goal_snapping_error.distance, 2 + 1e-9);
  EXPECT_NEAR(session.plan(request)->plan.cost, 18 + kPi / 2, 2);
}

TEST(Session, RefinesAndTimesThePath) {
  Session session(walled_room(), {.footprint = Footprint::disc(0.2)});
  PlanRequest request = across();
  request.refinement.smoother = SmootherChoice{"gradient"};
  request.trajectory.emplace();
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  ASSERT_TRUE(answer->refined);
  ASSERT_TRUE(answer->trajectory);
  EXPECT_LT(answer->path().length(), answer->plan.path.length());
  request.refinement.smoother = SmootherChoice{"no such smoother"};
  const auto plain = session.plan(request);
  ASSERT_TRUE(plain) << "the plan is valid without its refinement";
  EXPECT_TRUE(plain->fault);
  EXPECT_TRUE(plain->trajectory);
}

/// Batches, warm planners and clones give the answers of one planner that answers one query at a time.
TEST(Session, AnswersABatchLikeSingleRequests) {
  constexpr std::uint64_t kSeed = 16;
  SCOPED_TRACE(kSeed);
  Random random(kSeed);
  Session session(walled_room());
  std::vector<PlanRequest> requests;
  for (int i = 0; i < 60; ++i) {
    const auto any = [&] { return number_between(random, -2.5, 8.5); };
    requests.push_back({.start = {any(), any() - 1, 0}, .goals = {{{any(), any() - 1}}}});
  }
  ThreadWorkers workers(4);
  for (const char* name : {"astar", "jps"}) {
    const PlannerSpec spec{name};
    const auto answers = session.plan_all(requests, spec, workers);
    ASSERT_TRUE(answers) << answers.error().message;
    ASSERT_EQ(answers->size(), requests.size());
    int found = 0;
    for (std::size_t i = 0; i < requests.size(); ++i) {
      PlanRequest request = requests[i];
      request.planner = spec;
      const auto alone = session.plan(request);
      ASSERT_EQ((*answers)[i].has_value(), alone.has_value()) << i;
      if (!alone) {
        EXPECT_EQ((*answers)[i].error().status, alone.error().status);
        continue;
      }
      ++found;
      EXPECT_EQ((*answers)[i]->plan.path, alone->plan.path);
    }
    EXPECT_GT(found, 20);
    EXPECT_LT(found, 60);
  }
  EXPECT_FALSE(session.plan_all(requests, {"astr"}, workers));
  ThreadWorkers many(8);
  EXPECT_EQ(session.plan_all(std::span(requests).first(2), {"jps"}, many)->size(), 2U)
      << "fewer requests than workers";
  EXPECT_TRUE(session.plan_all({}, {"jps"}, workers)->empty());
}

TEST(Session, KeepsPlannersWarmUntilMapOrRobotChange) {
  Session session(walled_room());
  const PlannerSpec jps{"jps"};
  const Planner* first = nullptr;
  {
    const auto planner = session.planner(jps);
    ASSERT_TRUE(planner);
    first = &**planner;
    EXPECT_NE(&**session.planner(jps), first) << "the first is in use";
  }
  const auto both = session.planners(jps, 2);
  ASSERT_TRUE(both);
  EXPECT_TRUE(&*both->front() == first || &*both->back() == first);
  session.set_robot({.footprint = Footprint::disc(0.3)});
  const auto later = session.planner(jps);
  EXPECT_EQ((*later)->free_space().footprint(), Footprint::disc(0.3));
}

TEST(Session, PlansOnAnIndexThatItBuilds) {
  Session session(walled_room());
  PlanRequest request = across();
  const double cost = session.plan(request)->plan.cost;
  request.planner.name = "hub_labels";
  EXPECT_FALSE(session.build_index("astar"));
  EXPECT_FALSE(session.build_index("hub_label"));
  ASSERT_TRUE(session.build_index("hub_labels"));
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_NEAR(answer->plan.cost, cost, 1e-9);
  session.set_robot({.footprint = Footprint::disc(0.3)});
  EXPECT_EQ(session.plan(request).error().status, Status::index_mismatch);
}

TEST(Session, KeepsTheLastFieldOfCosts) {
  Session session(walled_room());
  const auto view = session.view();
  const auto first = session.cost_to_go(*view, {{90, 10}});
  ASSERT_TRUE(first);
  EXPECT_GT(first->metrics.expanded, 0U);
  EXPECT_NEAR(first->costs->cost({10, 10}), session.plan(across())->plan.cost, 1e-9);
  const auto second = session.cost_to_go(*view, {{90, 10}});
  EXPECT_EQ(second->costs, first->costs);
  EXPECT_EQ(second->metrics.expanded, 0U);
  EXPECT_NE(session.cost_to_go(*view, {{91, 10}})->costs, first->costs);
  EXPECT_EQ(session.cost_to_go(*view, {{50, 10}}).error().status, Status::goal_blocked);
}

TEST(Session, AnswersFromAFieldWithTheSameCost) {
  Session session(walled_room());
  PlanRequest request = across();
  const double cost = session.plan(request)->plan.cost;
  request.from_field = true;
  const auto first = session.plan(request);
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_NEAR(first->plan.cost, cost, 1e-9);
  EXPECT_GT(first->plan.metrics.expanded, 0U);
  EXPECT_EQ(session.plan(request)->plan.metrics.expanded, 0U) << "the field was kept";
  request.start.x = 3.05;  // in the wall
  const auto blocked = session.plan(request);
  ASSERT_FALSE(blocked);
  EXPECT_EQ(blocked.error().status, Status::start_blocked);
  EXPECT_NE(blocked.error().message.find("nearest free cell"), std::string::npos);
  request.nearest = true;
  EXPECT_TRUE(session.plan(request));
  request.goals.front().point.x = 1e300;
  EXPECT_EQ(session.plan(request).error().status, Status::goal_outside);
  request = across();
  request.from_field = true;
  for (const char* name : {"theta_star", "lattice", "car"}) {
    request.planner.name = name;
    EXPECT_EQ(session.plan(request).error().status, Status::unsupported_query) << name;
  }
}

TEST(Session, MovesTheEndsOfPlannersWithHeadings) {
  Session session(walled_room());
  PlanRequest request = across();
  request.planner.name = "lattice";
  request.start.x = 3.05;
  EXPECT_EQ(session.plan(request).error().status, Status::start_blocked);
  request.nearest = true;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(answer->notes.size(), 1U);
}

TEST(Session, MovesTheEndsOfABatchToo) {
  Session session(walled_room());
  PlanRequest request = across();
  request.start.x = 3.05;
  request.nearest = true;
  ThreadWorkers workers(2);
  const auto answers = session.plan_all({&request, 1}, {"jps"}, workers);
  ASSERT_TRUE(answers);
  ASSERT_TRUE(answers->front()) << answers->front().error().message;
  EXPECT_EQ(answers->front()->notes.size(), 1U);
}

TEST(Session, ExplainsAtLengthOnlyIfAsked) {
  Session session(walled_room(), {.footprint = Footprint::disc(1.5)});
  PlanRequest request{.start = {-0.4, -1.4, 0}, .goals = {{{6.4, -1.4}}}};
  const std::string full = session.plan(request).error().message;
  request.explain = false;
  const std::string brief = session.plan(request).error().message;
  EXPECT_NE(full.find("A path exists with"), std::string::npos) << full;
  EXPECT_LT(brief.size(), full.size());
  EXPECT_FALSE(brief.empty());
}

TEST(Session, SaysWhyThereIsNoPathAsData) {
  Session session(walled_room(), {.footprint = Footprint::disc(1.5)});
  const auto why = session.why_no_path({-0.4, -1.4}, {6.4, -1.4});
  ASSERT_TRUE(why);
  ASSERT_FALSE(why->ways.empty());
  EXPECT_TRUE(why->ways.front().smaller_robot);
  EXPECT_EQ(session.why_no_path({-5, 0}, {6, 0}).error().status, Status::start_outside);
  EXPECT_EQ(session.why_no_path({0, 0}, {60, 0}).error().status, Status::goal_outside);
}

TEST(NearestPose, IsTheNearestOfAllCells) {
  constexpr std::uint64_t kSeed = 5;
  SCOPED_TRACE(kSeed);
  Random random(kSeed);
  const auto shape = parse_footprint("0.35,0.1;0.35,-0.1;-0.35,-0.1;-0.35,0.1");
  ASSERT_TRUE(shape);
  Grid<CellState> cells(40, 30, CellState::free);
  for (int i = 0; i < 60; ++i) {
    cells[{random.between(0, 39), random.between(0, 29)}] = CellState::occupied;
  }
  const GridMap map = *make_grid_map(cells, {.resolution = 0.1, .metric = true});
  const FreeSpace space = *make_free_space(map, {.footprint = *shape});
  int moved = 0;
  for (int i = 0; i < 100; ++i) {
    const Pose asked{number_between(random, -5, 45), number_between(random, -5, 35),
                     number_between(random, -3, 3)};
    const auto found = nearest_pose(space, asked);
    ASSERT_TRUE(found);
    EXPECT_TRUE(space.fits(*found));
    EXPECT_EQ(found->heading, asked.heading);
    if (space.fits(asked)) {
      EXPECT_EQ(*found, asked);
      continue;
    }
    ++moved;
    const Point centre = centre_of(cell_at(asked.point()));
    double nearest = HUGE_VAL;
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        if (!space.fits(pose_at({x, y}, asked.heading))) continue;
        nearest = std::min(nearest, distance(centre, centre_of({x, y})));
      }
    }
    EXPECT_NEAR(distance(centre, found->point()), nearest, 1e-9);
  }
  EXPECT_GT(moved, 20);
  EXPECT_FALSE(nearest_pose(space, {std::nan(""), 0, 0}));
}

}  // namespace
}  // namespace wend
