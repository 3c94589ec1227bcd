#include "conformance/driven_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/random_polygon.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/curve.hpp"
#include "wend/path/path_collision.hpp"

namespace wend::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// 20 x 20 cells of a metre with a wall of one cell at x = 10, open from y = 12 on.
FreeSpace walled(const Footprint& footprint) {
  Grid<CellState> cells(20, 20, CellState::free);
  for (int y = 0; y < 12; ++y) cells[{10, y}] = CellState::occupied;
  return *make_free_space(*make_grid_map(cells), {.footprint = footprint});
}

Footprint rectangle(double length, double width) {
  return *Footprint::polygon(*Polygon::make({{length / 2, width / 2},
                                             {-length / 2, width / 2},
                                             {-length / 2, -width / 2},
                                             {length / 2, -width / 2}}));
}

/// The path through these poses, checked as the answer to a query from its first to its last.
DriveReport report_of(const FreeSpace& space, const std::vector<Pose>& poses,
                      const DriveRules& rules = {}) {
  return checked_drive(space, Path::through(poses), {poses.front(), {Goal(poses.back())}}, rules);
}

TEST(DrivenPath, IsFineIfItKeepsToTheRules) {
  const FreeSpace space = walled(rectangle(2, 1));
  const DriveReport report =
      report_of(space, {{2, 2, 0}, {6, 2, 0}, {4, 2, 0}, {7, 5, kPi / 2}, {7, 9, kPi / 2}},
                {.turning_radius = 3});
  EXPECT_THAT(report.fault, IsEmpty());
  EXPECT_NEAR(report.length, 4 + 2 + 3 * kPi / 2 + 4, 1e-9);
  EXPECT_NEAR(report.reversed, 2, 1e-9);
  EXPECT_EQ(report.gear_changes, 2);
  EXPECT_NEAR(report.least_radius, 3, 1e-9);
}

TEST(DrivenPath, MayNotCrossAThinWall) {
  for (const Footprint& footprint : {Footprint(), Footprint::disc(0.4), rectangle(2, 1)}) {
    const FreeSpace space = walled(footprint);
    EXPECT_THAT(report_of(space, {{5, 5, 0}, {15, 5, 0}}).fault, StartsWith("motion 0 at "));
    EXPECT_THAT(report_of(space, {{5, 13, 0}, {15, 13, 0}}).fault, IsEmpty());
  }
}

TEST(DrivenPath, MayTouchWhatItDoesNotOverlap) {
  EXPECT_THAT(report_of(walled(rectangle(2, 1)), {{9.5, 2, kPi / 2}, {9.5, 8, kPi / 2}}).fault,
              IsEmpty());
  EXPECT_THAT(report_of(walled(rectangle(2, 1)), {{9.51, 2, kPi / 2}, {9.51, 8, kPi / 2}}).fault,
              HasSubstr("overlaps the cell (10,1)"));
  EXPECT_THAT(report_of(walled(Footprint::disc(0.5)), {{9.5, 2, 0}}).fault, IsEmpty());
  EXPECT_THAT(report_of(walled(Footprint::disc(0.51)), {{9.5, 2, 0}}).fault,
              HasSubstr("overlaps the cell (10,1)"));
}

TEST(DrivenPath, SweepsCornersWhileItTurns) {
  const FreeSpace space = walled(rectangle(4, 1));
  // Along the wall it fits; turned, its corner hits the wall. The ends of both motions are free.
  const std::vector<Pose> poses{{8.2, 4, kPi / 2}, {8.2, 4, -kPi / 2}};
  EXPECT_THAT(report_of(space, {poses.front()}).fault, IsEmpty());
  EXPECT_THAT(report_of(space, {poses.back()}).fault, IsEmpty());
  EXPECT_THAT(report_of(space, {{8.2, 4, kPi / 2}, {8.2, 4, 0.1}}, {.turns_in_place = true}).fault,
              HasSubstr("overlaps the cell (10,"));
}

TEST(DrivenPath, MayNotSwallowAnObstacle) {
  Grid<CellState> cells(20, 20, CellState::free);
  cells[{10, 10}] = CellState::occupied;
  const FreeSpace space = *make_free_space(*make_grid_map(cells), {.footprint = rectangle(6, 6)});
  EXPECT_THAT(report_of(space, {{10.5, 10.5, 0}}).fault, HasSubstr("overlaps the cell (10,10)"));
}

TEST(DrivenPath, TakesUnknownCellsAndTheOutsideAsThePoliciesSay) {
  Grid<CellState> cells(20, 20, CellState::free);
  cells[{10, 10}] = CellState::unknown;
  for (const bool blocked : {false, true}) {
    const FreeSpace space = *make_free_space(
        *make_grid_map(cells), {.footprint = rectangle(2, 1),
                                .unknown = blocked ? UnknownPolicy::blocked : UnknownPolicy::free,
                                .outside = blocked ? OutsidePolicy::blocked : OutsidePolicy::free});
    EXPECT_EQ(report_of(space, {{5, 10.5, 0}, {15, 10.5, 0}}).fault.empty(), !blocked);
    EXPECT_EQ(report_of(space, {{5, 5, 0}, {0.5, 5, 0}}).fault.empty(), !blocked);
    EXPECT_THAT(report_of(space, {{5, 5, 0}, {-0.5, 5, 0}}).fault, HasSubstr("overlaps"));
  }
}

TEST(DrivenPath, KeepsToItsTurningRadiusAndItsGears) {
  const FreeSpace space = walled({});
  const std::vector<Pose> arc{{2, 2, 0}, {4, 4, kPi / 2}};
  EXPECT_THAT(report_of(space, arc, {.turning_radius = 2}).fault, IsEmpty());
  EXPECT_THAT(report_of(space, arc, {.turning_radius = 2.01}).fault,
              HasSubstr("turns by 1.57 rad with a radius of 2, less than 2.01"));
  const std::vector<Pose> slight{{2, 2, 0}, {2.01, 2, 0.00501}};
  EXPECT_THAT(report_of(space, slight, {.turning_radius = 2, .moves_aside = true}).fault,
              HasSubstr("turns by 0.00501 rad"));
  const std::vector<Pose> back{{6, 2, 0}, {4, 2, 0}};
  EXPECT_THAT(report_of(space, back).fault, IsEmpty());
  EXPECT_THAT(report_of(space, back, {.reverses = false}).fault, HasSubstr("drives in reverse"));
}

TEST(DrivenPath, TakesTheRadiusOfAVeryShortArcAsRounded) {
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(2000, 20, CellState::free)));
  for (int i = 0; i < 100; ++i) {
    const Pose from{1700 + i * 0.37, 7.3, 0.7};
    const Pose to = end_of(CurvePiece{1e-8, Turn::left}, from, 2);
    const DriveRules rules{.turning_radius = 2, .moves_aside = true};
    EXPECT_THAT(report_of(space, {from, to}, rules).fault, IsEmpty());
  }
}

TEST(DrivenPath, DrivesWhereItFaces) {
  const FreeSpace space = walled({});
  const std::vector<Pose> aside{{2, 2, 0}, {4, 2.5, 0}};
  EXPECT_THAT(report_of(space, aside).fault, HasSubstr("rad aside of its heading"));
  EXPECT_THAT(report_of(space, aside, {.moves_aside = true}).fault, IsEmpty());
  const std::vector<Pose> jump{{2, 2, 0}, {4, 2, 0}, {4, 2, 0.5}};
  EXPECT_THAT(report_of(space, jump).fault, HasSubstr("motion 1 turns in place by 0.5"));
  EXPECT_THAT(report_of(space, jump, {.turns_in_place = true}).fault, IsEmpty());
}

TEST(DrivenPath, BeginsAndEndsWhereItIsAskedTo) {
  const FreeSpace space = walled({});
  const Path path = Path::through({{2, 2, 0}, {6, 2, 0}});
  const auto fault = [&](const Pose& start, const Goal& goal) {
    return checked_drive(space, path, {start, {goal}}, {}).fault;
  };
  EXPECT_THAT(fault({2, 2, 2 * kPi}, Goal(Pose{6, 2, 0})), IsEmpty());
  EXPECT_THAT(fault({2, 2.1, 0}, Goal(Pose{6, 2, 0})), StartsWith("begins at "));
  EXPECT_THAT(fault({2, 2, 0.1}, Goal(Pose{6, 2, 0})), StartsWith("begins at "));
  EXPECT_THAT(fault({2, 2, 0}, Goal(Pose{6, 2.1, 0})), HasSubstr("which is not a goal"));
  EXPECT_THAT(fault({2, 2, 0}, Goal(Pose{6, 2, 0.1})), HasSubstr("which is not a goal"));
  EXPECT_THAT(fault({2, 2, 0}, Goal(Pose{6, 2.1, 0.1}, 0.2, 0.2)), IsEmpty());
  EXPECT_THAT(fault({2, 2, 0}, Goal(Point{6, 2})), IsEmpty());
  EXPECT_THAT(checked_drive(space, Path(), {{2, 2, 0}, {Goal(Point{6, 2})}}, {}).fault,
              "has no poses");
}

double drawn_number(double least, double greatest) {
  return least + (greatest - least) * *rc::gen::inRange(0, 1000001) / 1e6;
}

// Both are held to each other: what the library's sweep lets through must have no contact at any sample; and where
// a sample overlaps, the sweep must see a collision.
RC_GTEST_PROP(DrivenPath, CollidesOnlyWhereTheSweepOfTheLibraryDoes, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const int width = random.between(5, 30);
  const int height = random.between(5, 30);
  const GridMap map = *make_grid_map(random_states(random, width, height));
  const int shape = *rc::gen::inRange(0, 3);
  const Footprint footprint = shape == 0   ? Footprint()
                              : shape == 1 ? Footprint::disc(drawn_number(0.1, 2))
                                           : *Footprint::polygon(random_polygon());
  const FreeSpace space = *make_free_space(map, {.footprint = footprint});
  const double x = drawn_number(0, width);
  const double y = drawn_number(0, height);
  const double heading = drawn_number(-3, 3);
  const Pose from{x, y, heading};
  const double to_x = drawn_number(0, width);
  const double to_y = drawn_number(0, height);
  const Curve curve = cheapest_reeds_shepp(from, {to_x, to_y, 0}, 1.5);
  std::vector<Pose> poses{from};
  append_poses(curve, from, 1.5, poses);
  const DriveReport report = report_of(space, poses, {.turning_radius = 1.5});
  const bool sweep_is_free = !first_collision(Path::through(poses), space);
  RC_TAG(sweep_is_free ? "free" : "collides");
  if (sweep_is_free) RC_ASSERT(report.fault == "");
  RC_ASSERT(report.fault.empty() || report.fault.find("overlaps") != std::string::npos);
  RC_ASSERT(std::abs(report.length - curve.length()) < 1e-6);
  RC_ASSERT(report.gear_changes == curve.gear_changes());
}

}  // namespace
}  // namespace wend::test
