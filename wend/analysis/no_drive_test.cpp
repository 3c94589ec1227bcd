// Why hybrid_astar finds no drive: each answer is checked by planning with it, and by what no robot can do.

#include "wend/analysis/no_drive.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <string>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/planner_options.hpp"

namespace wend {
namespace {

FreeSpace driving_space(std::string_view drawing, std::string_view footprint) {
  return test::drawn_space(
      drawing, {.footprint = *parse_footprint(footprint), .outside = OutsidePolicy::blocked});
}

FreeSpace scaled_space(const FreeSpace& space, double scale) {
  FreeSpaceOptions options = space.options();
  options.footprint = options.footprint.scaled(scale);
  return *make_free_space(space.map(), options);
}

/// Of each search of a change.
constexpr std::uint64_t kExpansions = test::share_of(20'000U);

/// Without a budget of time, which a build with sanitizers exceeds.
bool drives(const FreeSpace& space, const Query& query, HybridAStarOptions options) {
  options.time_budget = 1000;
  return (*make_planner(space, options))->plan(query).has_value();
}

/// The same: it would end searches at another place on each machine.
NoDrive explained(const FreeSpace& space, const Query& query, HybridAStarOptions options) {
  options.time_budget = 1000;
  auto why = explain_no_drive(space, query, options, kExpansions);
  EXPECT_TRUE(why);
  return *why;
}

Query driven(Pose start, Pose goal) { return {start, {Goal(goal)}}; }

/// Two rooms and a door two cells wide.
std::string two_rooms() {
  std::string drawing;
  for (int row = 0; row < 9; ++row) {
    const bool door = row == 3 || row == 4;
    drawing += std::string(10, '.') + (door ? '.' : '#') + std::string(10, '.') + '\n';
  }
  return drawing;
}

TEST(ExplainNoDrive, FindsTheLargestRobotThatFitsThroughADoor) {
  const FreeSpace rooms = driving_space(two_rooms(), "1.5,1.15; 1.5,-1.15; -1.5,-1.15; -1.5,1.15");
  const Query query = driven({4, 4, 0}, {16, 4, 0});
  const HybridAStarOptions car{.turning_radius = 2};
  const NoDrive why = explained(rooms, query, car);
  EXPECT_EQ(why.status, Status::unreachable);
  ASSERT_TRUE(why.widest);
  EXPECT_EQ(why.widest->radius, 0.5);  // in the middle of a cell
  EXPECT_EQ(why.widest->narrowest.x, 10.5);
  ASSERT_TRUE(why.footprint_scale);
  EXPECT_LE(*why.footprint_scale, 1 / 1.15);  // as wide as the door
  EXPECT_GT(*why.footprint_scale, 0.7);
  EXPECT_TRUE(drives(scaled_space(rooms, *why.footprint_scale), query, car));
  EXPECT_FALSE(why.turning_radius);  // a robot that is too wide needs no other turns
  EXPECT_FALSE(why.reverse_helps);   // it may already
}

/// A corridor with two bends, three cells wide.
constexpr std::string_view kBends =
    "################\n"
    "#......#########\n"
    "#......#########\n"
    "#......#########\n"
    "####...#########\n"
    "####...#########\n"
    "####...#########\n"
    "####...........#\n"
    "####...........#\n"
    "####...........#\n"
    "################\n";

TEST(ExplainNoDrive, FindsTheTurningRadiusThatASlotNeeds) {
  const FreeSpace bends = driving_space(kBends, "1,0.9; 1,-0.9; -1,-0.9; -1,0.9");
  const Query query = driven({2.2, 2.5, 0}, {13.5, 8.5, 0});
  const HybridAStarOptions car{.turning_radius = 12, .allow_reverse = false};
  const NoDrive why = explained(bends, query, car);
  EXPECT_EQ(why.status, Status::unreachable);
  ASSERT_TRUE(why.turning_radius);
  EXPECT_LT(*why.turning_radius, 12);
  HybridAStarOptions tighter = car;
  tighter.turning_radius = *why.turning_radius;
  EXPECT_TRUE(drives(bends, query, tighter));
}

/// A pocket that is as long as the robot, and as wide: it fits one way only.
constexpr std::string_view kPocket =
    "##############\n"
    "#............#\n"
    "#............#\n"
    "#............#\n"
    "#............#\n"
    "#............#\n"
    "####....######\n"
    "####....######\n"
    "##############\n";

TEST(ExplainNoDrive, KnowsThatTurningDoesNotHelpSidewaysInAPocket) {
  const FreeSpace pocket = driving_space(kPocket, "1.9,0.9; 1.9,-0.9; -1.9,-0.9; -1.9,0.9");
  const Query query = driven({4, 3, 0}, {6, 7, 0});  // sideways
  const HybridAStarOptions car{.turning_radius = 3};
  const NoDrive why = explained(pocket, query, car);
  EXPECT_EQ(why.status, Status::unreachable);
  // A robot that slides sideways could leave: nothing proves that no drive exists.
  ASSERT_EQ(why.failure.causes.size(), 1U);
  const auto* const found = std::get_if<NoDriveFound>(&why.failure.causes.front());
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->why, NoDriveFound::Why::none_found);
  EXPECT_FALSE(why.certain);
  ASSERT_TRUE(why.footprint_scale);
  EXPECT_LT(*why.footprint_scale, 1);
  EXPECT_TRUE(drives(scaled_space(pocket, *why.footprint_scale), query, car));
}

TEST(ExplainNoDrive, KnowsWhereOnlyReverseHelps) {
  const FreeSpace pocket = driving_space(kPocket, "0.9,0.9; 0.9,-0.9; -0.9,-0.9; -0.9,0.9");
  const Query out = driven({6, 7, kPi / 2}, {9, 3, 0});  // facing the end of the pocket
  const HybridAStarOptions ahead{.turning_radius = 3, .allow_reverse = false};
  const NoDrive why = explained(pocket, out, ahead);
  EXPECT_FALSE(why.drive_exists());
  EXPECT_EQ(why.reverse_helps, std::optional(true));
  EXPECT_TRUE(explained(pocket, out, {.turning_radius = 3}).drive_exists());
}

TEST(ExplainNoDrive, LooksForASmallerRobotWhereAnEndIsBlocked) {
  const FreeSpace rooms = driving_space(two_rooms(), "1.5,0.9; 1.5,-0.9; -1.5,-0.9; -1.5,0.9");
  const Query query = driven({4, 4, 0}, {20, 4, 0});
  const NoDrive why = explained(rooms, query, {.turning_radius = 2});
  EXPECT_EQ(why.status, Status::goal_blocked);
  ASSERT_TRUE(why.footprint_scale);
  EXPECT_LE(*why.footprint_scale, 1 / 1.5);  // the rest of the room ahead of the goal
  EXPECT_GT(*why.footprint_scale, 1 / 1.5 - 0.02);
  EXPECT_FALSE(why.turning_radius);
}

TEST(ExplainNoDrive, SuggestsNothingWhereThereIsADriveOrNoGoal) {
  const FreeSpace rooms = driving_space(two_rooms(), "0.9,0.5; 0.9,-0.5; -0.9,-0.5; -0.9,0.5");
  const NoDrive found = explained(rooms, driven({4, 4, 0}, {16, 4, 0}), {.turning_radius = 2});
  EXPECT_TRUE(found.drive_exists());
  EXPECT_TRUE(found.widest);
  EXPECT_FALSE(found.footprint_scale || found.turning_radius || found.reverse_helps);
  const NoDrive outside = explained(rooms, driven({4, 4, 0}, {40, 4, 0}), {.turning_radius = 2});
  EXPECT_EQ(outside.status, Status::goal_outside);
  EXPECT_FALSE(outside.widest || outside.footprint_scale);
}

TEST(ExplainNoDrive, FailsAsThePlannerDoes) {
  const FreeSpace rooms = driving_space(two_rooms(), "disc:0.5");
  const auto why = explain_no_drive(rooms, driven({4, 4, 0}, {16, 4, 0}), {.turning_radius = 0});
  ASSERT_FALSE(why);
  EXPECT_EQ(why.error().where, "turning_radius");
}

TEST(ExplainNoDrive, StopsWhenItIsCancelled) {
  const FreeSpace rooms = driving_space(two_rooms(), "1.5,1.15; 1.5,-1.15; -1.5,-1.15; -1.5,1.15");
  const std::atomic<bool> cancel = true;
  Query query = driven({4, 4, 0}, {16, 4, 0});
  query.limits.cancel = &cancel;
  EXPECT_EQ(explained(rooms, query, {.turning_radius = 2}).status, Status::cancelled);
}

TEST(ExplainNoDrive, ExpandsTheSameEachTime) {
  const FreeSpace rooms = driving_space(two_rooms(), "1.5,1.15; 1.5,-1.15; -1.5,-1.15; -1.5,1.15");
  const Query query = driven({4, 4, 0}, {16, 4, 0});
  const NoDrive first = explained(rooms, query, {.turning_radius = 2});
  EXPECT_EQ(explained(rooms, query, {.turning_radius = 2}).expanded, first.expanded);
  EXPECT_LE(first.expanded, 20 * kExpansions);
}

}  // namespace
}  // namespace wend
