#include "wend/robot/footprint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/testing/random_polygon.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

using ::testing::HasSubstr;

TEST(Footprint, GrownCoversEverythingWithinTheMarginAndLittleMore) {
  const Footprint box = *Footprint::polygon(*Polygon::make({{3, 2}, {-3, 2}, {-3, -2}, {3, -2}}));
  const Footprint larger = box.grown(0.5);
  const Polygon& grown = *larger.outline();
  constexpr int kSteps = 48;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = 2 * kPi * i / kSteps;
    const Point aside{std::cos(angle), std::sin(angle)};
    for (const Point corner : box.outline()->corners()) {
      EXPECT_TRUE(grown.contains({corner.x + 0.499 * aside.x, corner.y + 0.499 * aside.y}))
          << angle;
      EXPECT_FALSE(grown.contains({corner.x + std::copysign(0.55, corner.x), corner.y}));
    }
  }
  EXPECT_FALSE(grown.contains({0, 2.501})) << "edges move by the margin";
  EXPECT_LE(box.grown(0.5).circumscribed_radius(), box.circumscribed_radius() + 0.55);
  EXPECT_EQ(Footprint::disc(2).grown(0.5), Footprint::disc(2.5));
  EXPECT_EQ(box.grown(0), box);
}

TEST(Footprint, IsAPointADiscOrAPolygon) {
  EXPECT_TRUE(Footprint().is_point());
  EXPECT_TRUE(Footprint::disc(0).is_point());
  const Footprint disc = Footprint::disc(0.2);
  EXPECT_FALSE(disc.is_point());
  EXPECT_EQ(disc.outline(), nullptr);
  EXPECT_EQ(disc.inscribed_radius(), 0.2);
  EXPECT_EQ(disc.circumscribed_radius(), 0.2);
  const auto box = parse_footprint("0.4,0.25; 0.4,-0.25; -0.3,-0.25; -0.3,0.25");
  ASSERT_TRUE(box) << box.error().message;
  ASSERT_NE(box->outline(), nullptr);
  EXPECT_EQ(box->inscribed_radius(), 0.25);
  EXPECT_DOUBLE_EQ(box->circumscribed_radius(), std::hypot(0.4, 0.25));
}

TEST(Footprint, IsValidUnlessItsDiscIsNot) {
  EXPECT_TRUE(Footprint::disc(3).valid());
  EXPECT_FALSE(Footprint::disc(-1).valid());
  EXPECT_FALSE(Footprint::disc(std::numeric_limits<double>::quiet_NaN()).valid());
  EXPECT_FALSE(Footprint::disc(std::numeric_limits<double>::infinity()).valid());
}

RC_GTEST_PROP(Footprint, CoversItsInscribedDiscAndNoMoreThanItsCircumscribedOne, ()) {
  const Polygon outline = test::random_polygon();
  const Footprint footprint = *Footprint::polygon(outline);
  const double angle = *rc::gen::inRange(0, 6283) / 1000.0;
  const auto covers = [&](double radius) {
    return outline.contains({radius * std::cos(angle), radius * std::sin(angle)});
  };
  RC_ASSERT(covers(footprint.inscribed_radius() * (1 - 1e-9)));
  RC_ASSERT(!covers(footprint.circumscribed_radius() * (1 + 1e-9)));
}

TEST(Footprint, RefusesAPolygonThatDoesNotContainTheBasePoint) {
  const auto polygon = Footprint::polygon(*Polygon::make({{1, 1}, {2, 1}, {2, 2}}));
  ASSERT_FALSE(polygon);
  EXPECT_THAT(polygon.error().message, HasSubstr("does not contain the robot's base point"));
  EXPECT_TRUE(Footprint::polygon(*Polygon::make({{0, -1}, {2, 0}, {0, 1}})));
}

RC_GTEST_PROP(ParseFootprint, ReadsBackWhatTextOfWrites, ()) {
  const Footprint footprint = *rc::gen::arbitrary<bool>()
                                  ? *Footprint::polygon(test::random_polygon())
                                  : Footprint::disc(*rc::gen::inRange(0, 100) / 7.0);
  const auto read = parse_footprint(text_of(footprint));
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == footprint);
}

TEST(ParseFootprint, ReadsEverySpelling) {
  EXPECT_EQ(*parse_footprint("point"), Footprint());
  EXPECT_EQ(*parse_footprint(" disc: 0.2 "), Footprint::disc(0.2));
  const auto plain = parse_footprint("0.4,0.25;0.4,-0.25;-0.3,0");
  ASSERT_TRUE(plain);
  EXPECT_EQ(*parse_footprint("0.4 , 0.25 ; 0.4,-0.25;-0.3,0;"), *plain);
  EXPECT_EQ(*parse_footprint("[[0.4, 0.25], [0.4, -0.25], [-0.3, 0]]"), *plain);
  EXPECT_EQ(*parse_footprint("[ [0.4,0.25],[0.4,-0.25] ,[-0.3,0], [0.4,0.25] ]"), *plain);
}

TEST(ParseFootprint, SaysWhatIsWrong) {
  const auto message = [](std::string_view text) {
    const auto footprint = parse_footprint(text);
    return footprint ? std::string("none") : footprint.error().message;
  };
  EXPECT_THAT(message(""), HasSubstr("'' is not a footprint: give corners"));
  EXPECT_THAT(message("0.2"), HasSubstr("did you mean 'disc:0.2'?"));
  EXPECT_THAT(message("disc:-1"), HasSubstr("the radius of the disc: '-1' is not between 0 and"));
  EXPECT_THAT(message("disc:1\x01"
                      "2"),
              HasSubstr("'1 2' is not a number"));
  EXPECT_LT(message("disc:" + std::string(100000, '1')).size(), 200);
  EXPECT_THAT(message("disc:nan"), HasSubstr("'nan' is not a number"));
  EXPECT_THAT(message("1,1;1,x;0,0"), HasSubstr("corner 2, '1,x', is not two numbers 'x,y'"));
  EXPECT_THAT(message("1,1;1,2,3;0,0"), HasSubstr("corner 2, '1,2,3', is not two numbers"));
  EXPECT_THAT(message("1,1;1,2"), HasSubstr("3 to 64 corners, not 2"));
  EXPECT_THAT(message("1,0;0,1;-1,0;nan,-1"), HasSubstr("corner 4 has a coordinate that is NaN"));
  EXPECT_THAT(message("[[1, 1], [1, 2]"), HasSubstr("is not a list of corners '[[x, y]"));
  EXPECT_THAT(message("[[1, 1] [1, 2]]"), HasSubstr("is not a list of corners"));
  EXPECT_THAT(message("1,1;2,1;2,2"), HasSubstr("does not contain the robot's base point"));
  EXPECT_THAT(message(std::string(1000, ';')), HasSubstr("at most 64 corners, not 1000"));
  EXPECT_LT(message(std::string(100000, 'x')).size(), 200);
}

}  // namespace
}  // namespace wend
