#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "conformance/random_edit.hpp"
#include "conformance/random_map.hpp"
#include "tests/testing/c_objects.hpp"
#include "wend/c/boundary.hpp"
#include "wend/c/objects.hpp"

namespace wend::test {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();

/// A random map with a random robot, for both interfaces.
class BothSessions {
 public:
  explicit BothSessions(Random& random) : random_(random) {
    const GridMap cells = random_map(random);
    Frame frame = cells.frame();
    frame.y_up = true;
    frame.metric = true;
    frame.origin.heading = one_of<double>(random, std::array{0.0, 0.0, 0.7});
    map_ = in_frame(cells, frame);
    const FreeSpaceOptions robot = random_robot(random, frame.resolution);
    cpp = std::make_unique<Session>(*map_, robot);
    auto options = session_options();
    options.unknown = robot.unknown == UnknownPolicy::free ? WEND_POLICY_FREE : WEND_POLICY_DEFAULT;
    if (robot.outside == OutsidePolicy::free) options.outside = WEND_POLICY_FREE;
    if (robot.outside == OutsidePolicy::blocked) options.outside = WEND_POLICY_BLOCKED;
    auto shape = robot_options();
    shape.radius = robot.footprint.circumscribed_radius();
    shape.clearance_distance = robot.clearance_distance;
    shape.clearance_cost = robot.clearance_cost;
    const auto its_robot = made_object<wend_robot>(
        [&](wend_robot** out, wend_error* error) { return wend_robot_create(&shape, out, error); });
    // Map and robot are freed at once: the session has its own.
    c = c_session(c_map(*map_).get(), its_robot.get(), &options);
  }

  /// A pose on the map, or near it.
  wend_pose pose() {
    const Cell cell = random_cell_or_outside(random_, map_->width(), map_->height());
    const MapPose pose = map_->frame().to_metres(
        Pose{cell.x + random_.uniform(), cell.y + random_.uniform(), 6 * random_.uniform() - 3});
    return {pose.x, pose.y, pose.heading};
  }

  std::unique_ptr<Session> cpp;
  Owned<wend_session> c;

 private:
  Random& random_;
  std::optional<GridMap> map_;
};

MapPose as_map_pose(const wend_pose& pose) { return {pose.x, pose.y, pose.heading}; }

void expect_same_plan(const Expected<PlanAnswer, RequestFailure>& expected, wend_status status,
                      const wend_plan* plan, const wend_error& error) {
  if (!expected) {
    EXPECT_EQ(status, c::status_of(expected.error().status));
    EXPECT_EQ(error.message, expected.error().message);
    EXPECT_EQ(error.expanded, expected.error().metrics.expanded);
    EXPECT_EQ(error.generated, expected.error().metrics.generated);
    EXPECT_EQ(plan, nullptr);
    return;
  }
  ASSERT_EQ(status, WEND_OK) << error.message;
  const std::vector<MapPose> poses = expected->poses();
  ASSERT_EQ(wend_plan_pose_count(plan), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(as_map_pose(wend_plan_poses(plan)[i]), poses[i]);
  }
  const double resolution = expected->space.map().frame().resolution;
  EXPECT_EQ(wend_plan_cost(plan), expected->plan.cost);
  EXPECT_EQ(wend_plan_bound(plan), expected->plan.bound);
  EXPECT_EQ(wend_plan_length(plan), expected->path().length() * resolution);
  EXPECT_EQ(wend_plan_expanded(plan), expected->plan.metrics.expanded);
  EXPECT_EQ(wend_plan_generated(plan), expected->plan.metrics.generated);
}

TEST(CSession, PlansAsTheCppInterface) {
  constexpr std::array<const char*, 6> kSpecs{
      "astar", "dijkstra", "astar:weight=2,connectivity=4", "jps", "theta_star", "lattice"};
  int found = 0;
  for (int seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    BothSessions sessions(random);
    for (int i = 0; i < 4; ++i) {
      std::vector<wend_pose> goals{sessions.pose()};
      if (random.chance(0.3)) goals.push_back(sessions.pose());
      if (random.chance(0.5)) goals[0].heading = kAnyHeading;
      wend_request request = request_to(goals[0], sessions.pose());
      request.goals = goals.data();
      request.goal_count = goals.size();
      request.planner = one_of(random, kSpecs);
      request.explain = random.chance(0.8) ? 1 : 0;
      if (random.chance(0.1)) request.expansions = random.below(6);
      if (random.chance(0.3)) request.tolerance = 2 * random.uniform();
      if (random.chance(0.3)) request.heading_tolerance = random.uniform();

      PlanRequest same;
      same.start = as_map_pose(request.start);
      for (const wend_pose& goal : goals) {
        MapGoal& its = same.goals.emplace_back(MapPoint{goal.x, goal.y});
        if (!std::isnan(goal.heading)) its.heading = goal.heading;
        its.tolerance = request.tolerance;
        its.heading_tolerance = request.heading_tolerance;
      }
      same.planner = parse_planner_specs(request.planner).value().front();
      same.limits.expansions = request.expansions;
      same.explain = request.explain == 1;

      wend_plan* plan = nullptr;
      wend_error error;
      const wend_status status = wend_session_plan(sessions.c.get(), &request, &plan, &error);
      const Owned<wend_plan> owner(plan);
      expect_same_plan(sessions.cpp->plan(same), status, plan, error);
      found += status == WEND_OK ? 1 : 0;
    }
  }
  EXPECT_GT(found, 100) << "too few paths to say anything";
}

TEST(CSession, AnswersQuestionsAboutPosesAsTheCppInterface) {
  std::array<int, 2> answers{};
  for (int seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    BothSessions sessions(random);
    const FreeSpace space = sessions.cpp->view().value().space;
    for (int i = 0; i < 5; ++i) {
      const wend_pose pose = sessions.pose();
      std::int32_t fits = -1;
      EXPECT_EQ(wend_session_fits(sessions.c.get(), &pose, &fits, nullptr), WEND_OK);
      ASSERT_EQ(fits, space.fits(space.map().frame().to_grid(as_map_pose(pose))) ? 1 : 0);
      ++answers[static_cast<std::size_t>(fits)];

      const auto expected = sessions.cpp->nearest(as_map_pose(pose));
      wend_pose nearest{0, 0, 0};
      const wend_status status = wend_session_nearest(sessions.c.get(), &pose, &nearest, nullptr);
      EXPECT_EQ(status, expected ? WEND_OK : WEND_UNSUPPORTED_QUERY);
      if (expected) {
        EXPECT_EQ(as_map_pose(nearest), *expected);
      }
    }
  }
  EXPECT_GT(answers[0], 50);
  EXPECT_GT(answers[1], 50);
}

TEST(CSession, StraightensAPathAndSetsPosesAlongIt) {
  const auto session = c_session(open_c_map(20, 20).get());
  const wend_pose goal{18.5, 7.5, kAnyHeading};
  wend_request request = request_to(goal);
  const auto plan = [&] {
    return made_object<wend_plan>([&](wend_plan** out, wend_error* error) {
      return wend_session_plan(session.get(), &request, out, error);
    });
  };
  request.straighten = 1;
  const auto line = plan();
  EXPECT_EQ(wend_plan_pose_count(line.get()), 2U);
  EXPECT_NEAR(wend_plan_length(line.get()), std::hypot(18, 7), 1e-9);
  EXPECT_GT(wend_plan_cost(line.get()), wend_plan_length(line.get()));
  request.spacing = 0.5;
  const auto points = plan();
  ASSERT_GT(wend_plan_pose_count(points.get()), 38U);
  for (std::size_t i = 1; i < wend_plan_pose_count(points.get()); ++i) {
    const wend_pose* const poses = wend_plan_poses(points.get());
    EXPECT_LE(std::hypot(poses[i].x - poses[i - 1].x, poses[i].y - poses[i - 1].y), 0.5 + 1e-9);
  }
}

TEST(CSession, TellsThePathsOfAnAnytimePlanner) {
  struct Told {
    std::vector<double> costs;
    std::vector<double> bounds;
    std::size_t poses = 0;  // of the last one
  };
  const auto session = c_session(open_c_map(20, 20).get());
  const wend_pose goal{18.5, 7.5, kAnyHeading};
  wend_request request = request_to(goal);
  Told told;
  request.context = &told;
  request.on_solution = [](const wend_plan* plan, void* context) {
    Told& paths = *static_cast<Told*>(context);
    paths.costs.push_back(wend_plan_cost(plan));
    paths.bounds.push_back(wend_plan_bound(plan));
    paths.poses = wend_plan_pose_count(plan);
    return int32_t{0};
  };
  for (const char* const planner : {"ara_star:initial_weight=5", "lattice:initial_weight=5"}) {
    SCOPED_TRACE(planner);
    told = {};
    request.planner = planner;
    const auto plan = made_object<wend_plan>([&](wend_plan** out, wend_error* error) {
      return wend_session_plan(session.get(), &request, out, error);
    });
    ASSERT_FALSE(told.costs.empty());
    EXPECT_TRUE(std::ranges::is_sorted(told.bounds, std::greater<>()));
    EXPECT_EQ(told.bounds.back(), 1);
    EXPECT_EQ(told.costs.back(), wend_plan_cost(plan.get()));
    EXPECT_EQ(told.poses, wend_plan_pose_count(plan.get()));
  }
}

TEST(CSession, SaysWhyAPathCannotBeRefined) {
  const auto session = c_session(open_c_map(20, 20).get());
  const wend_pose goal{12.5, 7.5, 0};
  wend_request request = request_to(goal, {5.5, 5.5, 0});
  request.planner = "lattice";
  request.straighten = 1;
  const auto refusal = refusal_of<wend_plan>([&](wend_plan** plan, wend_error* error) {
    return wend_session_plan(session.get(), &request, plan, error);
  });
  EXPECT_EQ(refusal.status, WEND_UNSUPPORTED_QUERY);
}

TEST(CSession, PlansOnTheMapAndForTheRobotOfNow) {
  const auto session = c_session(open_c_map(9, 3).get());
  const wend_pose middle{4.5, 1.5, 0};
  const auto fits = [&] {
    std::int32_t answer = -1;
    EXPECT_EQ(wend_session_fits(session.get(), &middle, &answer, nullptr), WEND_OK);
    return answer;
  };
  EXPECT_EQ(fits(), 1);
  wend_robot_options large = robot_options();
  large.radius = 2;
  const auto robot = made_object<wend_robot>(
      [&](wend_robot** out, wend_error* error) { return wend_robot_create(&large, out, error); });
  EXPECT_EQ(wend_session_set_robot(session.get(), robot.get(), nullptr), WEND_OK);
  EXPECT_EQ(fits(), 0) << "the robot hangs over the edge";
  EXPECT_EQ(wend_session_set_map(session.get(), open_c_map(9, 9).get(), nullptr), WEND_OK);
  EXPECT_EQ(fits(), 0);
  EXPECT_EQ(wend_session_set_robot(session.get(), nullptr, nullptr), WEND_OK);
  EXPECT_EQ(fits(), 1) << "a point";
}

TEST(CSession, EditsCellsLikeASession) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    BothSessions sessions(random);
    for (int i = 0; i < 3; ++i) {
      const GridMap map = sessions.cpp->view()->space.map();
      const CellBox box = random_box_on(random, map, 8);
      std::vector<std::uint8_t> states(static_cast<std::size_t>(box.size()));
      MapEdit edit{.corner = box.begin, .states = Grid<CellState>(box.width(), box.height())};
      std::size_t next = 0;
      for (const Cell cell : every_cell(edit.states)) {
        edit.states[cell] = random_state(random, 0.4);
        states[next++] = static_cast<std::uint8_t>(edit.states[cell]);
      }
      ASSERT_TRUE(sessions.cpp->edit(edit));
      ASSERT_EQ(wend_session_edit(sessions.c.get(), box.begin.x, box.begin.y, box.width(),
                                  box.height(), states.data(), states.size(), nullptr),
                WEND_OK);
      for (int n = 0; n < 10; ++n) {
        const wend_pose pose = sessions.pose();
        std::int32_t fits = -1;
        ASSERT_EQ(wend_session_fits(sessions.c.get(), &pose, &fits, nullptr), WEND_OK);
        const FreeSpace space = sessions.cpp->view()->space;
        ASSERT_EQ(fits != 0,
                  space.fits(map.frame().to_grid(MapPose{pose.x, pose.y, pose.heading})));
      }
    }
  }
}

TEST(CSession, RefusesEditsThatDoNotFit) {
  const auto session = c_session(open_c_map(5, 4).get(), nullptr, nullptr);
  const std::array<std::uint8_t, 4> states{0, 1, 2, 0};
  const std::array<std::uint8_t, 1> seven{7};
  const auto message = [&](int x, int y, int width, int height, const std::uint8_t* bytes,
                           std::size_t size) {
    wend_error error;
    EXPECT_NE(wend_session_edit(session.get(), x, y, width, height, bytes, size, &error), WEND_OK);
    return std::string(error.message);
  };
  EXPECT_EQ(message(4, 0, 2, 2, states.data(), 4),
            "cell (5,1) of the edit is not on the map of 5 x 4 cells");
  EXPECT_EQ(message(0, 0, 3, 2, states.data(), 4), "there are 4 bytes for a box of 3 x 2 cells");
  EXPECT_EQ(message(0, 0, 0, 2, states.data(), 0), "there are 0 bytes for a box of 0 x 2 cells");
  EXPECT_EQ(message(0, 0, 1, 1, seven.data(), 1),
            "states[0] is 7: 0 free, 1 occupied or 2 unknown expected");
  EXPECT_EQ(message(0, 0, 1, 1, nullptr, 1), "states is null");
  EXPECT_EQ(wend_session_edit(nullptr, 0, 0, 2, 2, states.data(), 4, nullptr),
            WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_session_edit(session.get(), 0, 0, 2, 2, states.data(), 4, nullptr), WEND_OK);
}

/// Why a request is refused after this change to a good one.
template <class Change>
Refusal refused_request(const Change& change) {
  static const Owned<wend_session> session = c_session(open_c_map(4, 4).get());
  static constexpr wend_pose kGoal{3.5, 3.5, kAnyHeading};
  wend_request request = request_to(kGoal);
  change(request);
  return refusal_of<wend_plan>([&](wend_plan** plan, wend_error* error) {
    return wend_session_plan(session.get(), &request, plan, error);
  });
}

TEST(CSession, RefusesRequestsThatAreNotComplete) {
  EXPECT_EQ(refused_request([](auto& request) { request.goals = nullptr; }).message,
            "wend_request has no goals");
  EXPECT_EQ(refused_request([](auto& request) { request.goal_count = 0; }).message,
            "wend_request has no goals");
  EXPECT_EQ(refused_request([](auto& request) { request.goal_count = SIZE_MAX; }).status,
            WEND_INVALID_ARGUMENT);
  EXPECT_EQ(refused_request([](auto& request) { request.planner = nullptr; }).message,
            "wend_request.planner is null");
  EXPECT_EQ(refused_request([](auto& request) { request.struct_size = 8; }).status,
            WEND_INVALID_ARGUMENT);
}

TEST(CSession, RefusesOtherPlanners) {
  EXPECT_EQ(refused_request([](auto& request) { request.planner = "bfs,dfs"; }).message,
            "wend_request.planner names 2 planners: one expected");
  for (const char* const spec :
       {"", "nothing", "astar:weight=-1", "astar:swirl=1", "astar:weight"}) {
    const auto refusal = refused_request([&](auto& request) { request.planner = spec; });
    EXPECT_EQ(refusal.status, WEND_INVALID_OPTION) << spec << ": " << refusal.message;
  }
}

TEST(CSession, RefusesNumbersThatAreNotFinite) {
  for (const double number : {kAnyHeading, kForEver, -kForEver}) {
    EXPECT_EQ(refused_request([&](auto& request) { request.start.x = number; }).message,
              "wend_request.start contains NaN or infinity");
    EXPECT_EQ(refused_request([&](auto& request) { request.start.heading = number; }).status,
              WEND_INVALID_ARGUMENT);
    EXPECT_EQ(refused_request([&](auto& request) { request.spacing = number; }).status,
              WEND_INVALID_ARGUMENT);
    EXPECT_EQ(refused_request([&](auto& request) { request.tolerance = number; }).status,
              WEND_INVALID_ARGUMENT);
    EXPECT_EQ(refused_request([&](auto& request) { request.heading_tolerance = number; }).status,
              WEND_INVALID_ARGUMENT);
    const wend_pose far{1.5, number, 0};
    EXPECT_EQ(refused_request([&](auto& request) { request.goals = &far; }).message,
              "wend_request.goals[0] contains NaN or infinity");
  }
  const wend_pose turned{1.5, 1.5, kForEver};
  EXPECT_EQ(refused_request([&](auto& request) { request.goals = &turned; }).status,
            WEND_INVALID_ARGUMENT);
  for (const double number : {kAnyHeading, -1.0}) {
    EXPECT_EQ(refused_request([&](auto& request) { request.seconds = number; }).status,
              WEND_INVALID_ARGUMENT);
  }
  EXPECT_EQ(refused_request([](auto& request) { request.spacing = -1; }).status,
            WEND_INVALID_ARGUMENT);
}

TEST(CSession, StopsAtLimits) {
  EXPECT_EQ(refused_request([](auto& request) { request.expansions = 2; }).message,
            "stopped after 2 expansions");
  EXPECT_EQ(refused_request([](auto& request) { request.seconds = 0; }).status, WEND_TIME_LIMIT);
}

TEST(CSession, RefusesNullPointers) {
  const auto map = open_c_map(4, 4);
  const auto session = c_session(map.get());
  const wend_pose pose{1.5, 1.5, 0};
  const wend_pose nowhere{kAnyHeading, 0, 0};
  wend_request request = request_to(pose);
  wend_pose nearest;
  std::int32_t fits = 0;
  const auto no_map = refusal_of<wend_session>([](wend_session** out, wend_error* error) {
    return wend_session_create(nullptr, nullptr, nullptr, out, error);
  });
  EXPECT_EQ(no_map.message, "map is null");
  EXPECT_EQ(wend_session_create(map.get(), nullptr, nullptr, nullptr, nullptr),
            WEND_INVALID_ARGUMENT);
  const auto no_session = refusal_of<wend_plan>([&](wend_plan** plan, wend_error* error) {
    return wend_session_plan(nullptr, &request, plan, error);
  });
  EXPECT_EQ(no_session.message, "session is null");
  const auto no_request = refusal_of<wend_plan>([&](wend_plan** plan, wend_error* error) {
    return wend_session_plan(session.get(), nullptr, plan, error);
  });
  EXPECT_EQ(no_request.message, "request is null");
  for (const wend_status status :
       {wend_session_plan(session.get(), &request, nullptr, nullptr),
        wend_session_set_map(nullptr, map.get(), nullptr),
        wend_session_set_map(session.get(), nullptr, nullptr),
        wend_session_set_robot(nullptr, nullptr, nullptr),
        wend_session_fits(nullptr, &pose, &fits, nullptr),
        wend_session_fits(session.get(), nullptr, &fits, nullptr),
        wend_session_fits(session.get(), &pose, nullptr, nullptr),
        wend_session_fits(session.get(), &nowhere, &fits, nullptr),
        wend_session_nearest(nullptr, &pose, &nearest, nullptr),
        wend_session_nearest(session.get(), nullptr, &nearest, nullptr),
        wend_session_nearest(session.get(), &pose, nullptr, nullptr),
        wend_session_nearest(session.get(), &nowhere, &nearest, nullptr)}) {
    EXPECT_EQ(status, WEND_INVALID_ARGUMENT);
  }
  wend_session_free(nullptr);
}

TEST(CSession, RefusesOtherPolicies) {
  const auto map = open_c_map(4, 4);
  const auto refused = [&](const wend_session_options& options) {
    return refusal_of<wend_session>([&](wend_session** out, wend_error* error) {
      return wend_session_create(map.get(), nullptr, &options, out, error);
    });
  };
  auto options = session_options();
  options.unknown = 3;
  EXPECT_EQ(refused(options).message,
            "wend_session_options has the policy 3, not a value of wend_policy");
  options = session_options();
  options.outside = -1;
  EXPECT_EQ(refused(options).status, WEND_INVALID_ARGUMENT);
  options = session_options();
  options.struct_size = 0;
  EXPECT_EQ(refused(options).status, WEND_INVALID_ARGUMENT);
}

TEST(CSession, EndsTheSearchWithThePathThatTheCallerTakes) {
  const auto session = c_session(open_c_map(20, 20).get());
  const wend_pose goal{18.5, 7.5, kAnyHeading};
  wend_request request = request_to(goal);
  request.planner = "lattice:initial_weight=5";
  std::vector<double> told;
  request.context = &told;
  request.on_solution = [](const wend_plan* plan, void* context) {
    static_cast<std::vector<double>*>(context)->push_back(wend_plan_cost(plan));
    return int32_t{1};
  };
  request.spacing = 0.1;  // done although the search was ended
  const auto plan = made_object<wend_plan>([&](wend_plan** out, wend_error* error) {
    return wend_session_plan(session.get(), &request, out, error);
  });
  EXPECT_EQ(told, std::vector<double>{wend_plan_cost(plan.get())});
  EXPECT_GT(wend_plan_bound(plan.get()), 1);
  EXPECT_GT(wend_plan_pose_count(plan.get()), 100U);
}

TEST(CSession, EndsCallsWhoseFlagIsSet) {
  const auto session = c_session(open_c_map(20, 20).get());
  const wend_pose goal{18.5, 7.5, kAnyHeading};
  wend_cancel* cancel = nullptr;
  ASSERT_EQ(wend_cancel_create(&cancel, nullptr), WEND_OK);
  wend_request request = request_to(goal);
  request.cancel = cancel;
  const auto status = [&](const char* planner) {
    wend_plan* plan = nullptr;
    wend_error error;
    request.planner = planner;
    const wend_status ended = wend_session_plan(session.get(), &request, &plan, &error);
    EXPECT_TRUE(ended == WEND_OK || error.message[0] != '\0');
    wend_plan_free(plan);
    return ended;
  };
  for (const int with_solutions : {0, 1}) {
    if (with_solutions != 0) {
      request.on_solution = [](const wend_plan* /*plan*/, void* /*context*/) { return int32_t{0}; };
    }
    for (const char* const planner : {"astar", "ara_star", "alt:landmarks=3", "hub_labels", "jps",
                                      "any_angle", "euclidean_labels", "lattice"}) {
      SCOPED_TRACE(planner);
      wend_cancel_set(cancel, 1);
      EXPECT_EQ(status(planner), WEND_CANCELLED);
      wend_cancel_set(cancel, 0);
      EXPECT_EQ(status(planner), WEND_OK);
    }
  }
  wend_cancel_set(nullptr, 1);
  wend_cancel_free(cancel);
}

}  // namespace
}  // namespace wend::test
