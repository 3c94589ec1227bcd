// The door to every planner: what it refuses, what it keeps, when it stops. All of it holds for
// every planner of the registry.

#include "wend/planner/planner.hpp"
#include "wend/index/file/index_bytes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

class EveryPlanner : public ::testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Planner> make(const FreeSpace& space) const {
    return std::move(make_planner(GetParam(), space).value());
  }

  /// Does it search, or look answers up in an index?
  static bool searches() { return !planners().find(GetParam())->index_support; }
};

constexpr const char* kLooksUp = "it looks answers up: there is no search to watch or to limit";

constexpr std::string_view kFourRooms = R"(
....#...
....#...
....#.##
)";
// (0,0) and (3,2) lie left of the wall, (5,0) and (7,0) right of it.

std::string status_of(Planner& planner, const Query& query) {
  Plan plan;
  return std::string(to_string(planner.plan(query, plan)));
}

TEST_P(EveryPlanner, SaysWhyAQueryCannotBeAnswered) {
  const auto planner = make(test::drawn_space(kFourRooms));
  const auto status = [&](Pose start, Pose goal) { return status_of(*planner, {start, {goal}}); };
  const Pose here{0.5, 0.5};
  for (const Pose& outside : {Pose{-0.001, 0.5}, Pose{8, 0.5}, Pose{0.5, -1}, Pose{0.5, 3},
                              Pose{kNotANumber, 0.5}, Pose{0.5, kNotANumber}, Pose{kInfinite, 0},
                              Pose{0, -kInfinite}, Pose{1e300, 0}, Pose{0, 4294967296.0}}) {
    EXPECT_EQ(status(outside, here), "start_outside") << outside.x << "," << outside.y;
    EXPECT_EQ(status(here, outside), "goal_outside") << outside.x << "," << outside.y;
  }
  EXPECT_EQ(status({4.5, 0.5}, here), "start_blocked");
  EXPECT_EQ(status(here, {4.5, 0.5}), "goal_blocked");
  EXPECT_EQ(status(here, {5.5, 0.5}), "unreachable");
  EXPECT_EQ(status({-1, 0}, {-1, 0}), "start_outside") << "the start is looked at first";
  EXPECT_EQ(status_of(*planner, {here, {}}), "unsupported_query");
  EXPECT_EQ(status(here, {3.5, 2.5}), "found");
}

TEST_P(EveryPlanner, TakesTheCellThatAPoseLiesIn) {
  const auto planner = make(test::drawn_space(kFourRooms));
  for (const Pose& pose : {Pose{1, 1}, Pose{1.999, 1.999}, Pose{1.5, 1.0, 3.0}}) {
    const auto plan = planner->plan({pose, {Goal(Point{1.5, 1.5})}});
    ASSERT_TRUE(plan);
    if (std::string(GetParam()) == "any_angle") {
      EXPECT_THAT(plan->path.points(), ElementsAre(pose.point(), Point{1.5, 1.5}));
    } else {
      EXPECT_THAT(plan->path.points(), ElementsAre(Point{1.5, 1.5}));
    }
  }
}

TEST_P(EveryPlanner, ForgetsTheLastAnswerWhenItFails) {
  const auto planner = make(test::drawn_space(kFourRooms));
  Plan plan;
  ASSERT_EQ(planner->plan(Query::between({0, 0}, {3, 2}), plan), Status::found);
  ASSERT_FALSE(plan.path.empty());
  for (const Cell goal : {Cell{4, 0}, Cell{5, 0}, Cell{9, 9}}) {
    plan.cost = 1;
    EXPECT_NE(planner->plan(Query::between({0, 0}, goal), plan), Status::found);
    EXPECT_TRUE(plan.path.empty());
    EXPECT_EQ(plan.cost, kInfinite);
    EXPECT_EQ(plan.bound, Plan::kNoBound);
    EXPECT_EQ(plan.metrics, SearchMetrics{}) << "nothing was searched";
  }
}

TEST_P(EveryPlanner, AnswersTheSameThroughBothDoors) {
  const auto planner = make(test::drawn_space(kFourRooms));
  const Query query = Query::between({0, 0}, {3, 2});
  Plan plan;
  ASSERT_EQ(planner->plan(query, plan), Status::found);
  // A planner that resumes would not search again.
  const auto other = make(test::drawn_space(kFourRooms))->plan(query);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->path, plan.path);
  EXPECT_EQ(other->cost, plan.cost);
  EXPECT_EQ(other->metrics, plan.metrics);
  const auto failed = planner->plan(Query::between({0, 0}, {5, 0}));
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().status, Status::unreachable);
}

TEST_P(EveryPlanner, GoesToOneOfSeveralGoalsAndPassesOverTheHopelessOnes) {
  const auto planner = make(test::drawn_space(kFourRooms));
  const Query query{pose_at({0, 0}),
                    {pose_at({9, 9}), pose_at({4, 0}), pose_at({5, 0}), pose_at({3, 2})}};
  const auto plan = planner->plan(query);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->path.points().back(), (Point{3.5, 2.5}));
}

TEST_P(EveryPlanner, IfAllGoalsAreHopelessGivesTheReasonOfTheFirst) {
  const auto planner = make(test::drawn_space(kFourRooms));
  const Pose outside = pose_at({9, 9});
  const Pose blocked = pose_at({4, 0});
  const Pose beyond = pose_at({5, 0});
  const Pose start = pose_at({0, 0});
  EXPECT_EQ(status_of(*planner, {start, {outside, blocked, beyond}}), "goal_outside");
  EXPECT_EQ(status_of(*planner, {start, {blocked, outside, beyond}}), "goal_blocked");
  EXPECT_EQ(status_of(*planner, {start, {beyond, outside, blocked}}), "unreachable");
}

TEST_P(EveryPlanner, KeepsItsOwnCopyOfTheLimitsWhileItIsStepped) {
  const auto planner = make(test::open_space(40, 40));
  Plan plan;
  auto query = std::make_unique<Query>(Query::between({0, 0}, {39, 39}));
  query->limits.expansions = 1;
  auto outcome = planner->begin(*query, plan);
  if (!planners().find(GetParam())->capabilities.can_step) {
    EXPECT_EQ(outcome, Status::unsupported_query);
    return;
  }
  query.reset();
  while (!outcome) outcome = planner->step(plan);
  EXPECT_EQ(to_string(*outcome), to_string(Status::expansion_limit));
  EXPECT_EQ(plan.metrics.expanded, 1U);
}

/// Believes nothing that it is told before it fits together.
class Auditor final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& event) override {
    EXPECT_TRUE(revisits || costs.count(state_of(event)) == 0) << "generated twice";
    check(event);
    ++generated;
  }
  void on_relax(const SearchEvent& event) override {
    ASSERT_EQ(costs.count(state_of(event)), 1U);
    EXPECT_LT(event.g, costs[state_of(event)]);
    check(event);
  }
  void on_expand(const SearchEvent& event) override {
    ASSERT_EQ(costs.count(state_of(event)), 1U) << "expanded before it was generated";
    if (settles) check(event);
    EXPECT_EQ(event.g, costs[state_of(event)]);
    last = event.cell;
    ++expanded;
  }

  bool settles = false;   // Theta* may choose another parent when it expands a cell
  bool revisits = false;  // a walk and a jump come to a cell more than once
  /// A corner is a cell with a direction.
  using State = std::pair<Cell, std::optional<double>>;

  std::map<State, double> costs;
  std::uint64_t generated = 0;
  std::uint64_t expanded = 0;
  Cell last;

 private:
  static State state_of(const SearchEvent& event) { return {event.cell, event.heading}; }
  static State parent_of(const SearchEvent& event) {
    return {event.parent.value_or(Cell{}), event.parent_heading};
  }

  void check(const SearchEvent& event) {
    if (event.parent) {
      ASSERT_EQ(costs.count(parent_of(event)), 1U);
      EXPECT_GT(event.g, costs[parent_of(event)]);
    } else {
      EXPECT_EQ(event.g, 0);
    }
    costs[state_of(event)] = event.g;
  }
};

TEST_P(EveryPlanner, TellsAnObserverEverything) {
  if (!searches()) GTEST_SKIP() << kLooksUp;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, 15, 12);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    const auto made = make_planner(GetParam(), *make_free_space(map));
    if (!made) {
      EXPECT_EQ(made.error().status, Status::unsupported_map);
      continue;
    }
    Planner* const planner = made->get();
    Auditor auditor;
    auditor.revisits = GetParam() == "random_walk" ||
                       jumps_on(map.uniform_terrain(), planners().find(GetParam())->capabilities);
    auditor.settles = planners().find(GetParam())->capabilities.any_angle;
    const Cell start = test::random_cell(random, 15, 12);  // the same with every compiler
    const Cell goal = test::random_cell(random, 15, 12);
    Query query = Query::between(start, goal);
    query.observer = &auditor;
    Plan plan;
    const Status status = planner->plan(query, plan);
    EXPECT_EQ(auditor.expanded, plan.metrics.expanded);
    EXPECT_EQ(auditor.generated, plan.metrics.generated);
    // An anytime planner goes on after it has expanded the goal.
    if (status == Status::found && !planner->anytime()) {
      const std::vector<Point> points = plan.path.points();
      EXPECT_EQ(auditor.last, cell_at(GetParam() == "d_star_lite" ? points.front() : points.back()))
          << "it searches backwards";
    }
  }
}

TEST_P(EveryPlanner, PlansOnTheFreeSpaceThatItWasUpdatedTo) {
  const auto planner = make(test::drawn_space(kFourRooms));
  EXPECT_EQ(status_of(*planner, Query::between({0, 0}, {7, 0})), "unreachable");
  const SpaceChange changed{false, {CellBox{{4, 1}, {5, 2}}}};
  const auto updated = planner->update(test::drawn_space(R"(
....#...
........
....#.##
)"),
                                       changed);
  if (searches()) {
    ASSERT_TRUE(updated);
    EXPECT_EQ(status_of(*planner, Query::between({0, 0}, {7, 0})), "found");
  } else {  // an edit does not start to build an index
    ASSERT_FALSE(updated);
    EXPECT_EQ(updated.error().status, Status::index_mismatch);
    EXPECT_EQ(status_of(*planner, Query::between({0, 0}, {7, 0})), "index_mismatch");
  }
  ASSERT_TRUE(planner->update(test::open_space(100, 50)));
  EXPECT_EQ(planner->free_space().width(), 100);
  EXPECT_EQ(status_of(*planner, Query::between({0, 0}, {99, 49})), "found");
  ASSERT_TRUE(planner->update(test::open_space(2, 1)));
  EXPECT_EQ(status_of(*planner, Query::between({0, 0}, {99, 49})), "goal_outside");
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryPlanner, ::testing::ValuesIn(planner_names("cells")),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend
