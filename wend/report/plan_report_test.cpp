#include "wend/report/plan_report.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/robot/car_primitives.hpp"

namespace wend {
namespace {

using nlohmann::json;

constexpr Frame kPlanFrame{.resolution = 0.5, .origin = {-1, 2, 0}, .y_up = true, .metric = true};

TEST(PlanJson, HasAPlanInCellsAndMetres) {
  PlanResult result{.planner = "astar", .plan = {}, .reason = {}};
  result.times = {.load = 4e-3, .free_space = 2e-3, .planner = 3e-6, .search = 1.5e-6};
  result.plan.path = Path({{0, 0}, {1, 0}});
  result.plan.cost = 1;
  result.plan.bound = 1;
  result.plan.metrics = {.expanded = 2, .generated = 5, .max_frontier = 3};
  result.footprint = *parse_footprint("0.4,0;-0.2,0.3;-0.2,-0.3");
  EXPECT_EQ(
      plan_json(result, kPlanFrame),
      R"({"schema":1,"planner":"astar","status":"found","cost":1.0,"length_cells":1.0,"length_m":0.5,)"
      R"("path":[[0,0],[1,0]],"path_m":[[-0.75,2.25],[-0.25,2.25]],"bound":1.0,)"
      R"("start_shift":{"cells":0.0,"m":0.0,"degrees":0.0},)"
      R"("goal_shift":{"cells":0.0,"m":0.0,"degrees":0.0},)"
      R"("robot_radius":0.4,"footprint":"0.4,0;-0.2,0.3;-0.2,-0.3","notes":[],)"
      R"("metrics":{"expanded":2,"generated":5,"max_frontier":3},"times":{"load_us":4000.0,)"
      R"("free_space_us":2000.0,"planner_us":3.0,"index_us":null,"search_us":1.5}})"
      "\n");
}

TEST(HeadingText, HasNoDigitsOfRounding) {
  EXPECT_EQ(heading_text(2.2e-16, kPlanFrame), "0deg");
  EXPECT_EQ(heading_text(-2.2e-16, kPlanFrame), "0deg");
  EXPECT_EQ(heading_text(kPi / 6 + 2.2e-16, kPlanFrame), "30deg");
  EXPECT_EQ(heading_text(0, kPlanFrame), "E");
}

TEST(PlanJson, SaysWhatAnIndexTook) {
  PlanResult result{.planner = "hub_labels", .plan = {}, .reason = {}};
  result.times.index = 1.25;
  const json times = json::parse(plan_json(result, kPlanFrame)).at("times");
  EXPECT_EQ(times.at("index_us"), 1.25e6);
  EXPECT_TRUE(times.at("planner_us").is_null()) << "none was made";
}

PlanResult driven() {
  PlanResult result{.planner = "car", .plan = {}, .reason = {}};
  result.capabilities.headings = true;
  result.states = 1600;
  result.plan.path = Path::through({{1, 0, 0}, {2, 1, kPi / 2}, {2, 2, kPi / 2}});
  result.plan.moves = {"FWD_LEFT", "FWD"};
  result.plan.cost = 2.5;
  result.plan.bound = 1;
  result.plan.start_snapping_error = {.distance = 0.5, .turn = kPi / 4};
  result.plan.metrics = {.expanded = 2, .generated = 5, .max_frontier = 3};
  return result;
}

TEST(PlanJson, HasADriveInCornersAndInTheMapsFrame) {
  const json plan = json::parse(plan_json(driven(), kPlanFrame));
  EXPECT_EQ(plan.at("path"), json::parse("[[1,0],[2,1],[2,2]]"));
  EXPECT_TRUE(plan.at("path").at(0).at(0).is_number_integer());
  EXPECT_EQ(plan.at("headings"), json::parse(R"(["E","N","N"])"));
  EXPECT_EQ(plan.at("moves"), json::parse(R"(["FWD_LEFT","FWD"])"));
  EXPECT_EQ(plan.at("steps"), 2);
  EXPECT_EQ(plan.at("path_m"), json::parse("[[-0.5,2],[0,2.5],[0,3]]"));
  EXPECT_EQ(plan.at("yaw"), json({0.0, kPi / 2, kPi / 2}));
  EXPECT_NEAR(plan.at("length_cells").get<double>(), kPi / 2 + 1, 1e-12);
  EXPECT_NEAR(plan.at("length_m").get<double>(), kPi / 4 + 0.5, 1e-12);
  EXPECT_EQ(plan.at("start_shift"), json::parse(R"({"cells":0.5,"m":0.25,"degrees":45})"));
  EXPECT_EQ(plan.at("goal_shift"), json::parse(R"({"cells":0,"m":0,"degrees":0})"));
  EXPECT_EQ(plan.at("states"), 1600);
}

TEST(PlanJson, HasThePosesToDriveAndTheirGears) {
  PlanResult result = driven();
  result.plan.path = Path::through({{1, 0, 0}, {3, 0, 0}, {2, 0, 0}, {2, 0, 1}});
  result.plan.moves = {"FWD", "REV", "TURN_LEFT"};
  const json plan = json::parse(plan_json(result, kPlanFrame));
  EXPECT_EQ(plan.at("poses_m"), json::parse("[[-0.5,2,0],[0.5,2,0],[0,2,0],[0,2,1]]"));
  EXPECT_EQ(plan.at("gears"), json::parse("[1,-1,0]"));
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(9, 9)), {});
  result.refined = refined_path(result.plan.path, {.spacing = 1},
                                *refined(result.plan.path, space, {.spacing = 1}), space);
  const json dense = json::parse(plan_json(result, kPlanFrame));
  EXPECT_EQ(dense.at("gears"), json::parse("[1,1,-1,0]"));
  EXPECT_EQ(dense.at("poses_m").at(1), json::parse("[0,2,0]"));
  EXPECT_EQ(dense.at("yaw"), plan.at("yaw")) << "those keys keep the plan";
}

TEST(PlanJson, TurnsADrivesYawWithTheMapButNotItsHeadings) {
  Frame frame = kPlanFrame;
  frame.origin.heading = kPi / 2;
  const json turned = json::parse(plan_json(driven(), frame));
  EXPECT_EQ(turned.at("yaw"), json({kPi / 2, kPi, kPi}));
  EXPECT_EQ(turned.at("headings"), json::parse(R"(["E","N","N"])"));
  frame.y_up = false;
  EXPECT_EQ(json::parse(plan_json(driven(), frame)).at("headings"),
            json::parse(R"(["E","S","S"])"));
}

TEST(PlanJson, HasNumbersWhereADriveIsOnNoCorner) {
  PlanResult result = driven();
  result.plan.path = Path::through({{1, 0.5, 0}, {2, 0.5, 0.25}});
  const json plan = json::parse(plan_json(result, kPlanFrame));
  EXPECT_EQ(plan.at("path"), json::parse("[[1,0.5],[2,0.5]]"));
  EXPECT_EQ(plan.at("headings"), json::parse(R"(["E",0.25])"));
}

TEST(PlanJson, OfACarThatFailedHasTheSameKeys) {
  PlanResult result = driven();
  result.status = Status::unreachable;
  result.reason = "boxed in";
  result.plan.path.clear();
  result.plan.moves.clear();
  const json failed = json::parse(plan_json(result, kPlanFrame));
  for (const char* key : {"path", "headings", "moves", "path_m", "yaw", "poses_m", "gears"}) {
    EXPECT_EQ(failed.at(key), json::array()) << key;
  }
  for (const char* key : {"cost", "steps", "start_shift", "goal_shift", "length_cells"}) {
    EXPECT_TRUE(failed.at(key).is_null()) << key;
  }
  EXPECT_EQ(failed.at("states"), 1600);
}

RC_GTEST_PROP(PlanJson, OfADriveIsReadAsTheSamePath, (bool y_up)) {
  const Frame frame{.resolution = 0.05, .origin = {-3, 7, 0.3}, .y_up = y_up, .metric = true};
  PlanResult result{.planner = "car", .plan = {}, .reason = {}};
  result.capabilities.headings = true;
  CornerPose place{{*rc::gen::inRange(100, 1 << 20), 1000000}, *rc::gen::elementOf(kAllHeadings)};
  result.plan.path.drive_to(pose_of(place));
  for (int moves = *rc::gen::inRange(0, 40); moves > 0; --moves) {
    place = moved(place, static_cast<CarMove>(*rc::gen::inRange(0, kCarMoves)));
    result.plan.path.drive_to(pose_of(place));
  }
  const auto path = parse_path_json(plan_json(result, frame), "plan.json", frame);
  RC_ASSERT(path.has_value());
  RC_ASSERT(*path == result.plan.path);
}

TEST(PlanJson, NeverHoldsNumbersThatAreNone) {
  PlanResult result{
      .planner = "dfs", .status = Status::unreachable, .plan = {}, .reason = "too far"};
  result.plan.cost = std::numeric_limits<double>::infinity();
  const json failed = json::parse(plan_json(result, kPlanFrame));
  EXPECT_EQ(failed.at("status"), "unreachable");
  EXPECT_EQ(failed.at("reason"), "too far");
  EXPECT_TRUE(failed.at("cost").is_null());
  EXPECT_TRUE(failed.at("bound").is_null());
  EXPECT_TRUE(failed.at("length_cells").is_null());
  EXPECT_EQ(failed.at("path"), json::array());
  EXPECT_EQ(failed.at("path_m"), json::array());
}

TEST(PlanJson, StaysUtf8WhateverTheReasonHolds) {
  PlanResult result{.planner = "dfs", .status = Status::cancelled, .plan = {}, .reason = "\xff!"};
  EXPECT_EQ(json::parse(plan_json(result, kPlanFrame)).at("reason"), "\xef\xbf\xbd!");
}

constexpr Frame kYDown{};
constexpr Frame kYUp{.y_up = true};

Plan driven(CornerPose place, const std::vector<CarMove>& moves, const Frame& frame, int unit = 1) {
  Plan plan;
  plan.path.drive_to(pose_of(place));
  for (const CarMove move : moves) {
    place = moved(place, move, unit);
    plan.path.drive_to(pose_of(place));
    plan.moves.push_back(name_of(move, frame));
  }
  return plan;
}

TEST(DriveCommands, AreTheStartAndALineForEachMove) {
  const Plan plan = driven({{1, 0}, Heading::plus_x},
                           {CarMove::fwd_plus, CarMove::fwd, CarMove::rev_minus}, kYDown);
  EXPECT_EQ(drive_commands(plan, kYDown),
            "Start (1,0,E)\n"
            "Go FWD_RIGHT -> (2,1,S)\n"
            "Go FWD -> (2,2,S)\n"
            "Go REV_LEFT -> (3,1,W)\n");
}

/// Expanded again, the lines are the moves, and each ends at the last of its poses.
TEST(DriveCommands, MergeEqualMovesThatFollowEachOther) {
  using enum CarMove;
  const Plan plan = driven({{1, 1}, Heading::plus_x}, {fwd, fwd, fwd, fwd_plus, rev, rev}, kYDown);
  EXPECT_EQ(drive_commands(plan, kYDown),
            "Start (1,1,E)\n"
            "Go 3 x FWD -> (4,1,E)\n"
            "Go FWD_RIGHT -> (5,2,S)\n"
            "Go 2 x REV -> (5,0,S)\n");
}

TEST(DriveCommands, SayTheSameOfTheSameDriveWithYUp) {
  const Plan plan =
      driven({{10, 10}, Heading::plus_x}, {CarMove::fwd_minus, CarMove::fwd}, kYUp, 5);
  EXPECT_EQ(drive_commands(plan, kYUp),
            "Start (10,10,E)\n"
            "Go FWD_RIGHT -> (15,5,S)\n"
            "Go FWD -> (15,0,S)\n");
}

TEST(DriveCommands, OfACarThatIsThereAreTheStart) {
  EXPECT_EQ(drive_commands(driven({{1000000, 0}, Heading::minus_y}, {}, kYDown), kYDown),
            "Start (1000000,0,N)\n");
}

TEST(DriveCommands, OfNothingAreNone) { EXPECT_EQ(drive_commands({}, kYDown), ""); }

}  // namespace
}  // namespace wend
