// What a robot's polygon touches, and with what.

#include "wend/robot/sweep/contact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/testing/drawn_map.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"

namespace wend {
namespace {

FreeSpace contact_space(std::string_view drawing, std::string_view footprint,
                        OutsidePolicy outside = OutsidePolicy::blocked) {
  return test::drawn_space(drawing, {.footprint = *parse_footprint(footprint), .outside = outside});
}

std::string contact_in_words(const FreeSpace& space, const Pose& pose) {
  const auto contact = contact_at(space, pose);
  return contact ? describe(*contact, space) : "nothing";
}

constexpr std::string_view kContactRoom =
    ".......\n"
    ".......\n"
    ".....#.\n"
    ".......\n"
    ".......\n";
constexpr std::string_view kContactShape = "1.2,0.6; 1.2,-0.6; -1.2,-0.6; -1.2,0.6";

TEST(Contact, NamesTheCornerInAnObstacle) {
  const FreeSpace space = contact_space(kContactRoom, kContactShape);
  // Row 0 is the top row, so +y is on the right.
  EXPECT_EQ(contact_in_words(space, {4, 1.6, 0}),
            "its front right corner lies in the obstacle cell (5,2)");
  EXPECT_EQ(contact_in_words(space, {4, 3.4, 0}),
            "its front left corner lies in the obstacle cell (5,2)");
  EXPECT_EQ(contact_in_words(space, {4, 3.4, kPi}),
            "its rear right corner lies in the obstacle cell (5,2)");
  EXPECT_EQ(contact_in_words(space, {2, 2.5, 0}), "nothing");
}

TEST(Contact, NamesTheMapsEdge) {
  EXPECT_EQ(contact_in_words(contact_space(kContactRoom, kContactShape), {1, 2.5, 0}),
            "its rear right corner reaches over the map's edge");
  EXPECT_EQ(contact_in_words(contact_space(kContactRoom, kContactShape, OutsidePolicy::free),
                             {1, 2.5, 0}),
            "nothing");
}

TEST(Contact, NamesTheSideThatCrossesAnObstacle) {
  EXPECT_EQ(contact_in_words(contact_space(kContactRoom, kContactShape), {4, 2.5, 0}),
            "its side from the front left corner to the front right corner crosses the obstacle "
            "cell (5,2)");
  EXPECT_EQ(contact_in_words(contact_space(kContactRoom, "1.5,1.5; 1.5,-1.5; -1.5,-1.5; -1.5,1.5"),
                             {5.5, 2.5, 0}),
            "it covers the obstacle cell (5,2)");
}

TEST(Contact, NamesCornersOfOtherPolygonsByTheirCoordinates) {
  EXPECT_EQ(contact_in_words(contact_space(kContactRoom, "1.5,0; -1,1; -1,-1"), {4, 2.5, 0}),
            "its corner (1.5,0) lies in the obstacle cell (5,2)");
}

TEST(Contact, TellsUnknownCellsApart) {
  EXPECT_EQ(
      contact_in_words(contact_space("....?\n", "1,0.4; 1,-0.4; -1,-0.4; -1,0.4"), {3.5, 0.5, 0}),
      "its front right corner lies in the unknown cell (4,0)");
}

/// A contact exists exactly where the robot does not fit, and what it names is there.
RC_GTEST_PROP(Contact, IsThereWhereTheRobotDoesNotFit, ()) {
  const auto walls = *rc::gen::container<std::string>(36, rc::gen::element('.', '.', '.', '#'));
  std::string drawing;
  for (std::size_t i = 0; i < walls.size(); i += 6) drawing += walls.substr(i, 6) + '\n';
  const bool open = *rc::gen::arbitrary<bool>();
  const double x = *rc::gen::inRange(0, 600) / 100.0;
  const double y = *rc::gen::inRange(0, 600) / 100.0;
  const double heading = *rc::gen::inRange(-314, 315) / 100.0;
  const FreeSpace space = contact_space(drawing, "1.1,0.4; 0.9,-0.7; -0.8,-0.4; -0.6,0.6",
                                        open ? OutsidePolicy::free : OutsidePolicy::blocked);
  const Pose pose{x, y, heading};
  const auto contact = contact_at(space, pose);
  RC_ASSERT(contact.has_value() == !space.fits(pose));
  if (!contact) return;
  const PlacedPolygon robot(*space.outline(), pose);
  if (contact->obstacle) {
    RC_ASSERT(space.obstacles().blocked()[*contact->obstacle]);
    RC_ASSERT(robot.overlaps(*contact->obstacle));
  }
  if (contact->corner) {
    const Point corner = robot.corners()[*contact->corner];
    const auto cell = cell_under(space, corner);
    RC_ASSERT(cell == contact->obstacle);
  }
}

}  // namespace
}  // namespace wend
