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

TEST(Footprint, MayHaveItsBasePointOutside) {
  const auto fork = parse_footprint("0.9,0.2; 0.1,0.2; 0.1,-0.2; 0.9,-0.2");
  ASSERT_TRUE(fork) << fork.error().message;
  EXPECT_FALSE(fork->covers_base_point());
  EXPECT_EQ(fork->inscribed_radius(), 0);
  EXPECT_DOUBLE_EQ(fork->circumscribed_radius(), std::hypot(0.9, 0.2));
  EXPECT_NEAR(fork->inner_disc().radius, 0.2, 1e-3);
  EXPECT_NEAR(fork->inner_disc().centre.x, 0.3, 2e-3) << "the nearest of the largest discs";
  EXPECT_NEAR(fork->inner_disc().centre.y, 0, 2e-3);
  const Footprint tenfold = fork->scaled(10);
  EXPECT_FALSE(tenfold.covers_base_point());
  EXPECT_DOUBLE_EQ(tenfold.inner_disc().radius, 10 * fork->inner_disc().radius);
  EXPECT_DOUBLE_EQ(tenfold.inner_disc().centre.x, 10 * fork->inner_disc().centre.x);
  const auto on_edge = Footprint::polygon(*Polygon::make({{0, -1}, {2, 0}, {0, 1}}));
  EXPECT_TRUE(on_edge->covers_base_point());
  EXPECT_EQ(on_edge->inscribed_radius(), 0);
  EXPECT_TRUE(Footprint::disc(1).covers_base_point());
}

RC_GTEST_PROP(Footprint, CoversItsInnerDisc, ()) {
  const Footprint footprint = *Footprint::polygon(test::random_outline());
  const InnerDisc& disc = footprint.inner_disc();
  constexpr double kRounding = 1e-9;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2 * kPi * i / 24;
    const double radius = disc.radius - kRounding;
    if (radius < 0) break;
    RC_ASSERT(footprint.outline()->contains(
        {disc.centre.x + radius * std::cos(angle), disc.centre.y + radius * std::sin(angle)}));
  }
  if (footprint.covers_base_point()) RC_ASSERT(disc.centre == (Point{0, 0}));
  if (!footprint.covers_base_point()) RC_ASSERT(footprint.inscribed_radius() == 0);
  if (!footprint.covers_base_point()) RC_ASSERT(disc.radius > 0);
}

TEST(Footprint, IsARectangleAroundItsCentreAhead) {
  EXPECT_EQ(*Footprint::rectangle(4.2, 1.8, 1.35),
            *parse_footprint("3.45,0.9; -0.75,0.9; -0.75,-0.9; 3.45,-0.9"));
  EXPECT_EQ(text_of(*Footprint::rectangle(0.6, 0.4, 0.1)), "0.4,0.2;-0.2,0.2;-0.2,-0.2;0.4,-0.2");
  EXPECT_EQ(*Footprint::rectangle(2, 1), *parse_footprint("1,0.5;-1,0.5;-1,-0.5;1,-0.5"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(Footprint::rectangle(0, 1).error().message,
              HasSubstr("length is 0: a number above 0"));
  EXPECT_THAT(Footprint::rectangle(1, -1).error().message, HasSubstr("width is -1"));
  EXPECT_THAT(Footprint::rectangle(1, nan).error().message, HasSubstr("width is nan"));
  EXPECT_THAT(Footprint::rectangle(1e300, 1).error().message, HasSubstr("to 1e6 expected"));
  EXPECT_THAT(Footprint::rectangle(1, 1, nan).error().message, HasSubstr("distance ahead is nan"));
  EXPECT_FALSE(Footprint::rectangle(1e6, 1, 1e6));
  EXPECT_FALSE(Footprint::rectangle(1e-300, 1e-300));
}

RC_GTEST_PROP(ParseFootprint, ReadsBackWhatTextOfWrites, ()) {
  const Footprint footprint = *rc::gen::arbitrary<bool>()
                                  ? *Footprint::polygon(test::random_outline())
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
  EXPECT_EQ(*parse_footprint("0.4,0.25;0.4,0.25;0.4,-0.25;-0.3,0;-0.3,0"), *plain);
  EXPECT_EQ(*parse_footprint("-0.3,0;0.4,-0.25;0.4,0.25")->outline(),
            *Polygon::make({{-0.3, 0}, {0.4, -0.25}, {0.4, 0.25}}));
  EXPECT_EQ(*parse_footprint("rect:4.2x1.8"), *Footprint::rectangle(4.2, 1.8));
  EXPECT_EQ(*parse_footprint(" rect: 4.2 x 1.8 , 1.35 "), *Footprint::rectangle(4.2, 1.8, 1.35));
  EXPECT_EQ(*parse_footprint("rect:1e0x1e-1,-2"), *Footprint::rectangle(1, 0.1, -2));
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
  EXPECT_THAT(message("1,1;1,2"), HasSubstr("3 to 4096 corners, not 2"));
  EXPECT_THAT(message("1,0;0,1;-1,0;nan,-1"), HasSubstr("corner 4 has a coordinate that is NaN"));
  EXPECT_THAT(message("[[1, 1], [1, 2]"), HasSubstr("is not a list of corners '[[x, y]"));
  EXPECT_THAT(message("[[1, 1] [1, 2]]"), HasSubstr("is not a list of corners"));
  EXPECT_THAT(message("1,1;2,2;2,1;1,2"), HasSubstr("begin at corners 1 and 3 cross or touch"));
  EXPECT_THAT(message("1,1;1,1;2,2;3,3"), HasSubstr("turns back on itself at corner"));
  EXPECT_THAT(message("1,1;2e6,2;2,1"), HasSubstr("corner 2 has a coordinate"));
  EXPECT_THAT(message(std::string(10000, ';')), HasSubstr("at most 4096 corners, not 10000"));
  EXPECT_THAT(message("rect:"), HasSubstr("write rect:LENGTHxWIDTH"));
  EXPECT_THAT(message("rect:2"), HasSubstr("the rectangle '2': write rect:LENGTHxWIDTH"));
  EXPECT_THAT(message("rect:2x1,1,1"), HasSubstr("write rect:LENGTHxWIDTH,"));
  EXPECT_THAT(message("rect:2xb"), HasSubstr("its width, 'b', is not a number"));
  EXPECT_THAT(message("rect:2x1,"), HasSubstr("its distance ahead, '', is not a number"));
  EXPECT_THAT(message("rect:0x1"), HasSubstr("length is 0"));
  EXPECT_LT(message("rect:" + std::string(100000, '1')).size(), 200);
  EXPECT_LT(message(std::string(100000, 'x')).size(), 200);
}

}  // namespace
}  // namespace wend
