#include "wend_ros/planning.hpp"

#include <gtest/gtest.h>
#include <wend_ros/PlanPathFeedback.h>

#include <cmath>
#include <fstream>
#include <future>
#include <set>

#include "wend/geometry/angle.hpp"
#include "wend/planner/planners.hpp"
#include "wend_ros/feedback.hpp"
#include "wend_ros/path_message.hpp"
#include "wend_ros/tracking.hpp"

namespace wend_ros {
namespace {

/// A room of 10 m with a wall that leaves a way at the top.
wend::GridMap room() {
  wend::Grid<wend::CellState> cells(100, 100, wend::CellState::free);
  for (int y = 0; y < 80; ++y) cells[{50, y}] = wend::CellState::occupied;
  return *wend::make_grid_map(cells, {.resolution = 0.1, .y_up = true, .metric = true});
}

/// Answers queries in a room.
class Planning {
 public:
  Planning() { session_.set_map(room()); }

  void set_robot(const Parameters& parameters) { session_.set_robot(robot_of(parameters)); }

  PlanResult answer(const Parameters& parameters, const Ask& ask, const Watch& watch = {}) {
    return wend_ros::answer(session_, *session_.view(), parameters, ask, watch).result;
  }

 private:
  wend::Session session_{session_options()};
};

Ask ask(wend::MapPose start, wend::MapPose goal) {
  return {.start = start, .goals = {goal}, .planner = {}, .options = {}};
}

TEST(StatusCodes, OfEveryReasonHaveANameAndNav2sNumbers) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(wend::Status::index_mismatch); ++i) {
    const StatusCode code = code_of(static_cast<wend::Status>(i));
    EXPECT_NE(code, StatusCode::unknown_error) << i;
    names.insert(to_string(code));
  }
  EXPECT_GE(names.size(), 14U);
  EXPECT_EQ(static_cast<int>(code_of(wend::Status::start_outside)), 203);
  EXPECT_EQ(static_cast<int>(code_of(wend::Status::goal_outside)), 204);
  EXPECT_EQ(static_cast<int>(code_of(wend::Status::start_blocked)), 205);
  EXPECT_EQ(static_cast<int>(code_of(wend::Status::goal_blocked)), 206);
  EXPECT_EQ(static_cast<int>(code_of(wend::Status::time_limit)), 207);
  EXPECT_EQ(static_cast<int>(code_of(wend::Status::unreachable)), 208);
}

TEST(Planning, AnswersInTheMapsFrame) {
  Planning planning;
  const PlanResult result = planning.answer({}, ask({1.05, 1.05, 0}, {9.05, 1.05, 0}));
  ASSERT_EQ(result.status, 0) << result.reason;
  EXPECT_EQ(result.path.header.frame_id, "map");
  EXPECT_NEAR(result.path.poses.front().pose.position.x, 1.05, 1e-9);
  EXPECT_NEAR(result.path.poses.back().pose.position.x, 9.05, 1e-9);
  EXPECT_GT(result.path_metrics.length, 15);
  EXPECT_NEAR(result.path_metrics.length, result.cost * 0.1, 1e-9);
  EXPECT_EQ(result.bound, 1);
  EXPECT_EQ(result.smoothed.poses.size(), result.path.poses.size());
}

TEST(Planning, StampsTheTrajectoryByItsLimits) {
  Planning planning;
  Parameters parameters;
  EXPECT_EQ(parameters.set("speed", "2"), "");
  EXPECT_NE(parameters.set("acceleration", "0"), "");
  const PlanResult result =
      planning.answer(parameters, ask({1.05, 1.05, 0}, {1.05, 7.05, wend::kPi / 2}));
  ASSERT_EQ(result.status, 0) << result.reason;
  const auto& poses = result.trajectory.poses;
  ASSERT_GT(poses.size(), 2U);
  EXPECT_EQ(poses.front().header.stamp, ros::Time(0));
  EXPECT_EQ(poses[1].header.stamp, ros::Time(0.1));
  EXPECT_NEAR(poses.back().header.stamp.toSec(), 6 / 2.0 + 2 / 1.0, 0.02) << "a trapezoid";
  EXPECT_NEAR(poses.back().pose.position.y, 7.05, 1e-9);
  const nav_msgs::Path later = starting_at(ros::Time(100), result.trajectory);
  EXPECT_EQ(later.header.stamp, ros::Time(100));
  EXPECT_NEAR((later.poses.back().header.stamp - poses.back().header.stamp).toSec(), 100, 1e-6);
}

Parameters without_escape() {
  Parameters parameters;
  EXPECT_EQ(parameters.set("escape", "0"), "");
  return parameters;
}

TEST(Planning, TellsWhyThereIsNoPlan) {
  Planning planning;
  EXPECT_EQ(planning.answer({}, ask({-1, 1, 0}, {9, 1, 0})).status, 203);
  EXPECT_EQ(planning.answer({}, ask({1, 1, 0}, {9, 11, 0})).status, 204);
  EXPECT_EQ(planning.answer(without_escape(), ask({5.05, 1, 0}, {9, 1, 0})).status, 205);
  const PlanResult blocked = planning.answer({}, ask({1, 1, 0}, {5.05, 1, 0}));
  EXPECT_EQ(blocked.status, 206);
  EXPECT_NE(blocked.reason.find("obstacle"), std::string::npos) << blocked.reason;
}

TEST(Planning, SaysWhatWouldHelpInTheNamesOfItsParameters) {
  Planning planning;
  Parameters wide;
  EXPECT_EQ(wide.set("robot_radius", "1.5"), "");
  planning.set_robot(wide);
  const PlanResult result = planning.answer(wide, ask({2.05, 2.05, 0}, {8.05, 2.05, 0}));
  EXPECT_EQ(result.status, 208);
  EXPECT_NE(result.reason.find("(~robot_radius 0.95)"), std::string::npos) << result.reason;
}

TEST(Planning, SaysWhereARobotWithAHeadingFits) {
  Planning planning;
  Ask blocked = ask({5.05, 1.05, 0}, {9.05, 1.05, 0});
  blocked.planner = "lattice";
  const PlanResult refused = planning.answer(without_escape(), blocked);
  ASSERT_EQ(refused.status, 205);
  ASSERT_EQ(refused.nearest_start.size(), 1U);
  EXPECT_NE(refused.reason.find("it fits is at (4.95,1.05) m, cell (49,10): `nearest_start`"),
            std::string::npos)
      << refused.reason;
}

TEST(Planning, OnCellsEndsWithTheHeadingOfTheGoal) {
  Planning planning;
  Ask asked = ask({1.05, 1.05, 0}, {9.05, 1.05, 2});
  const PlanResult result = planning.answer({}, asked);
  ASSERT_EQ(result.status, 0) << result.reason;
  ASSERT_FALSE(result.smoothed.poses.empty());
  for (const nav_msgs::Path* path : {&result.path, &result.smoothed, &result.trajectory}) {
    EXPECT_NEAR(pose_from(path->poses.back().pose)->heading, 2, 1e-9);
  }
  asked.goals[0].heading = -1;
  const PlanResult other = planning.answer({}, asked);
  EXPECT_EQ(other.path.poses.size(), result.path.poses.size()) << "it is turned to at the end";
  EXPECT_NEAR(pose_from(other.path.poses.back().pose)->heading, -1, 1e-9);
  asked.any_heading = true;
  const PlanResult any = planning.answer({}, asked);
  EXPECT_NEAR(std::abs(pose_from(any.path.poses.back().pose)->heading), wend::kPi / 2, 1e-9)
      << "as the last step leads";
}

TEST(Planning, ATrajectoryThatTurnsAtItsEndKeepsToTheLimits) {
  Planning planning;
  const PlanResult result = planning.answer({}, ask({1.05, 1.05, 0}, {4.05, 1.05, 3}));
  ASSERT_EQ(result.status, 0) << result.reason;
  const auto trajectory = trajectory_from(result.trajectory);
  ASSERT_TRUE(trajectory) << trajectory.error().message;
  EXPECT_EQ(why_untrackable(*trajectory, {}), "");
  const wend::MapPose end = trajectory->at(trajectory->duration()).pose;
  EXPECT_NEAR(end.x, 4.05, 1e-9);
  EXPECT_NEAR(end.heading, 3, 1e-9);
}

TEST(Planning, OfSeveralGoalsEndsWithTheHeadingOfTheOneThatItReaches) {
  Planning planning;
  Ask asked = ask({1.05, 1.05, 0}, {9.05, 1.05, 2});
  asked.goals.push_back({3.05, 1.05, -2});
  const PlanResult result = planning.answer({}, asked);
  ASSERT_EQ(result.status, 0) << result.reason;
  EXPECT_NEAR(pose_from(result.path.poses.back().pose)->heading, -2, 1e-9);
}

TEST(Planning, NamesTheNearestFreePoseAndPlansFromIt) {
  Planning planning;
  Ask blocked = ask({5.05, 1.05, 1}, {9.05, 1.05, 0});
  const PlanResult refused = planning.answer(without_escape(), blocked);
  ASSERT_EQ(refused.status, 205);
  ASSERT_EQ(refused.nearest_start.size(), 1U);
  EXPECT_TRUE(refused.nearest_goal.empty());
  EXPECT_NEAR(refused.nearest_start.front().position.x, 4.95, 1e-9);
  EXPECT_NEAR(pose_from(refused.nearest_start.front())->heading, 1, 1e-9);
  blocked.nearest = true;
  const PlanResult moved = planning.answer(without_escape(), blocked);
  ASSERT_EQ(moved.status, 0) << moved.reason;
  EXPECT_NE(moved.reason.find("planning from"), std::string::npos) << moved.reason;
  EXPECT_NEAR(moved.path.poses.front().pose.position.x, 4.95, 1e-9);
}

TEST(Planning, BeginsWithAWayOut) {
  Planning planning;
  const PlanResult led = planning.answer({}, ask({5.05, 1.05, 0}, {9.05, 1.05, 0}));
  ASSERT_EQ(led.status, 0) << led.reason;
  EXPECT_NEAR(led.lead_out, 0.1, 1e-9);
  EXPECT_EQ(led.lead_out_poses, 1U);
  EXPECT_EQ(led.remaining, 0);
  EXPECT_NEAR(led.path.poses.front().pose.position.x, 5.05, 1e-9);
}

TEST(Planning, EndsAtTheClosestPlaceIfAsked) {
  Planning planning;
  Ask into_the_wall = ask({1.05, 1.05, 0}, {5.05, 1.05, 0});
  EXPECT_EQ(planning.answer({}, into_the_wall).status, 206);
  into_the_wall.closest = true;
  const PlanResult closest = planning.answer({}, into_the_wall);
  ASSERT_EQ(closest.status, 0) << closest.reason;
  EXPECT_NEAR(closest.remaining, 0.1, 1e-9);
}

TEST(Planning, EndsWithinTheToleranceOfTheParameters) {
  Planning planning;
  Parameters parameters;
  const Ask into_the_wall = ask({1.05, 1.05, 0}, {5.05, 1.05, 0});
  EXPECT_EQ(planning.answer(parameters, into_the_wall).status,
            static_cast<int>(StatusCode::goal_blocked));
  EXPECT_NE(parameters.set("goal_tolerance", "-1"), "");
  EXPECT_EQ(parameters.set("goal_tolerance", "0.5"), "");
  const PlanResult result = planning.answer(parameters, into_the_wall);
  ASSERT_EQ(result.status, 0) << result.reason;
  EXPECT_NEAR(result.path.poses.back().pose.position.x, 4.55, 1e-9);
  EXPECT_EQ(parameters.set("planner", "car"), "");
  EXPECT_EQ(parameters.set("goal_heading_tolerance", "3.2"), "");
  const PlanResult drive = planning.answer(parameters, ask({1.05, 1.05, 0}, {4.05, 1.05, 2}));
  ASSERT_EQ(drive.status, 0) << drive.reason;
  EXPECT_LE(drive.cost, 30 - 5 + 1) << "straight, to the near edge of the tolerance";
}

TEST(Planning, ChecksPlannersAndOptions) {
  Planning planning;
  Ask wrong = ask({1, 1, 0}, {9, 1, 0});
  wrong.planner = "astr";
  const PlanResult unknown = planning.answer({}, wrong);
  EXPECT_EQ(unknown.status, 201);
  EXPECT_NE(unknown.reason.find("astar"), std::string::npos) << unknown.reason;
  wrong.planner = "astar";
  wrong.options = "weight=-3";
  EXPECT_EQ(planning.answer({}, wrong).status, 201);
  wrong.options = "weight=3";
  const PlanResult weighted = planning.answer({}, wrong);
  EXPECT_EQ(weighted.status, 0) << weighted.reason;
  EXPECT_EQ(weighted.bound, 3);
}

TEST(Planning, TakesItsOptionsFromTheParameters) {
  Planning planning;
  Parameters parameters;
  EXPECT_EQ(parameters.set("lambda", "2"), "");
  EXPECT_EQ(parameters.text("weight"), "2") << "lambda is its other name";
  EXPECT_NE(parameters.set("lambda", "-1"), "");
  EXPECT_EQ(parameters.set("smooth", "false"), "");
  const PlanResult result = planning.answer(parameters, ask({1, 1, 0}, {9, 1, 0}));
  EXPECT_EQ(result.bound, 2);
  EXPECT_TRUE(result.smoothed.poses.empty());
}

TEST(Planning, IsStoppedByItsFlag) {
  Planning planning;
  const std::atomic<bool> cancel{true};
  const PlanResult result = planning.answer({}, ask({1, 1, 0}, {9, 1, 0}), {&cancel, nullptr});
  EXPECT_EQ(result.status, static_cast<int>(StatusCode::cancelled));
}

TEST(Planning, TellsThePathsOfAnAnytimePlanner) {
  Planning planning;
  Ask anytime = ask({1, 1, 0}, {9, 1, 0});
  anytime.planner = "ara_star:initial_weight=10";
  SearchWatch watch(false);
  EXPECT_EQ(watch.solutions().count, 0U);
  const PlanResult result = planning.answer(
      {}, anytime, {nullptr, &watch, [&](const wend::Plan& plan) { watch.on_solution(plan); }});
  ASSERT_EQ(result.status, 0) << result.reason;
  EXPECT_GT(watch.solutions().count, 1U) << "the first path goes along the wall";
  EXPECT_EQ(watch.solutions().cost, result.cost);
  EXPECT_EQ(watch.solutions().bound, 1);
}

TEST(Feedback, HasTheBestPathAndWhatItProves) {
  SearchWatch watch(false);
  wend::Plan plan;
  plan.cost = 20;
  plan.bound = 2;
  watch.on_solution(plan);
  plan.cost = 15;
  plan.bound = 1.5;
  watch.on_solution(plan);
  std::promise<PlanPathFeedback> first;
  bool told = false;
  const auto publish = [&](const PlanPathFeedback& message) {
    if (!told) first.set_value(message);
    told = true;
  };
  const Feedback<PlanPathFeedback, decltype(publish)> feedback(watch, publish);
  const PlanPathFeedback message = first.get_future().get();
  EXPECT_EQ(message.solutions, 2U);
  EXPECT_EQ(message.cost, 15);
  EXPECT_EQ(message.bound, 1.5);
  EXPECT_EQ(message.best_bound, 10) << "no path costs less";
}

TEST(Planning, AnswersFromTheFieldWithTheSameCost) {
  Planning planning;
  Ask from_field = ask({1, 1, 0}, {9, 1, 0});
  const double cost = planning.answer({}, from_field).cost;
  from_field.from_field = true;
  const PlanResult first = planning.answer({}, from_field);
  ASSERT_EQ(first.status, 0) << first.reason;
  EXPECT_TRUE(first.from_field);
  EXPECT_NEAR(first.cost, cost, 1e-9);
  from_field.start = {2, 2, 0};
  const PlanResult second = planning.answer({}, from_field);
  EXPECT_TRUE(second.from_field);
  EXPECT_EQ(second.metrics.expanded, 0U) << "the field was there already";
  from_field.from_field = false;
  EXPECT_NEAR(planning.answer({}, from_field).cost, second.cost, 1e-9);
}

/// A path to drive is kept; a question is answered anew.
TEST(Planning, KeepsAPathUnlessAnotherIsCheaperByTheShare) {
  for (const std::string planner : {"astar", "theta_star", "hybrid_astar"}) {
    wend::Session session{session_options()};
    session.set_map(room());
    const auto cost = [&](double keep) {
      Ask asked = ask({1, 1, 0}, {9, 1, 0});
      asked.planner = planner;
      asked.keep = keep;
      return answer(session, *session.view(), Parameters(), asked).result.cost;
    };
    const double around = cost(0.5);
    const wend::Grid<wend::CellState> door(1, 10, wend::CellState::free);
    ASSERT_TRUE(session.edit({.corner = {50, 60}, .states = door}));
    const double through = cost(0);
    EXPECT_LT(through, 0.95 * around) << planner;
    EXPECT_NEAR(cost(0.5), around, 1e-6 * around) << planner;
    EXPECT_NEAR(cost(0.01), through, 1e-6 * through) << planner;
  }
}

TEST(Parameters, AreDescribedFromTheSchema) {
  const Parameters parameters;
  const auto description = parameters.description();
  ASSERT_EQ(description.groups.size(), 1U);
  std::set<std::string> names;
  for (const auto& parameter : description.groups.front().parameters) names.insert(parameter.name);
  for (const wend::PlannerInfo& planner : wend::planners()) {
    for (const wend::OptionInfo& option : planner.options) {
      EXPECT_TRUE(names.contains(option.name)) << option.name;
    }
  }
  for (const char* name : {"planner", "smooth_alpha", "smooth_beta"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  std::set<std::string> not_there;
  const auto look_for = [&](const wend::FieldInfo& field) {
    if (!names.contains(std::string(field.name))) not_there.emplace(field.name);
  };
  for (const wend::RequestField& field : wend::request_fields()) look_for(field.info);
  for (const wend::RobotField& field : wend::robot_fields()) look_for(field.info);
  for (const wend::OptionInfo& limit : wend::option_schema<wend::TrajectoryLimits>()) {
    EXPECT_TRUE(names.contains(limit.name)) << limit.name;
  }
  // Messages have these, or they mean something else here. A new field is a parameter.
  EXPECT_EQ(not_there, (std::set<std::string>{"expansions", "explain", "from_field", "spacing",
                                              "straighten", "unknown"}));
  EXPECT_EQ(parameters.config().bools.size() + parameters.config().ints.size() +
                parameters.config().doubles.size() + parameters.config().strs.size(),
            names.size());
}

TEST(Parameters, TakeWhatIsRightAndTellTheRest) {
  Parameters parameters;
  dynamic_reconfigure::Config config;
  dynamic_reconfigure::DoubleParameter radius;
  radius.name = "robot_radius";
  radius.value = 0.3;
  dynamic_reconfigure::DoubleParameter weight;
  weight.name = "weight";
  weight.value = -1;
  config.doubles = {radius, weight};
  const auto faults = parameters.apply(config);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults.front().find("weight"), std::string::npos);
  EXPECT_EQ(parameters.number("robot_radius"), 0.3);
}

TEST(Parameters, HaveAFootprintInPlaceOfARadius) {
  Parameters parameters;
  EXPECT_EQ(parameters.set("robot_radius", "0.3"), "");
  EXPECT_EQ(parameters.footprint(), wend::Footprint::disc(0.3));
  EXPECT_EQ(parameters.set("footprint", "[[0.4, 0.2], [0.4, -0.2], [-0.3, 0]]"), "");
  EXPECT_EQ(parameters.footprint(), *wend::parse_footprint("0.4,0.2;0.4,-0.2;-0.3,0"));
  EXPECT_EQ(parameters.set("footprint", "rect:0.8x0.4,0.6"), "");
  EXPECT_EQ(parameters.footprint(), *wend::Footprint::rectangle(0.8, 0.4, 0.6));
  EXPECT_EQ(parameters.set("footprint", "[[0.9, 0.2], [0.1, 0.2], [0.1, -0.2], [0.9, -0.2]]"), "");
  EXPECT_FALSE(parameters.footprint().covers_base_point());
  EXPECT_NE(parameters.set("footprint", "[[1, 1], [2, 2]]").find("3 to 4096 corners"),
            std::string::npos);
  EXPECT_EQ(parameters.set("footprint", ""), "");
  EXPECT_EQ(parameters.footprint(), wend::Footprint::disc(0.3));
}

TEST(Parameters, ReadMotionPrimitivesFromAFile) {
  Parameters parameters;
  EXPECT_FALSE(parameters.primitives().has_value());
  EXPECT_NE(parameters.set("primitives", "/no/such/robot.mprim").find("robot.mprim"),
            std::string::npos);
  EXPECT_FALSE(parameters.primitives().has_value());
  const std::string file = testing::TempDir() + "robot.mprim";
  std::ofstream(file) << "resolution_m: 0.1\nnumberofangles: 1\ntotalnumberofprimitives: 1\n"
                         "primID: 0\nstartangle_c: 0\nendpose_c: 1 0 0\n"
                         "additionalactioncostmult: 1\nintermediateposes: 2\n0 0 0\n0.1 0 0\n";
  EXPECT_EQ(parameters.set("primitives", file), "");
  ASSERT_TRUE(parameters.primitives().has_value());
  EXPECT_EQ(parameters.primitives()->resolution(), 0.1);
  EXPECT_EQ(parameters.set("primitives", ""), "");
  EXPECT_FALSE(parameters.primitives().has_value());
}

}  // namespace
}  // namespace wend_ros
