#include "wend/geometry/heading.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

TEST(Heading, TurnsAsDrawn) {
  EXPECT_EQ(right_of(Heading::north), Heading::east);
  EXPECT_EQ(right_of(Heading::east), Heading::south);
  EXPECT_EQ(right_of(Heading::south), Heading::west);
  for (const Heading heading : kAllHeadings) {
    EXPECT_EQ(left_of(right_of(heading)), heading);
    EXPECT_EQ(opposite(opposite(heading)), heading);
    EXPECT_NE(opposite(heading), heading);
  }
}

TEST(Heading, NorthIsUpAsDrawn) {
  EXPECT_EQ(ahead(Heading::north, false), (Cell{0, -1}));
  EXPECT_EQ(ahead(Heading::north, true), (Cell{0, 1}));
  EXPECT_EQ(ahead(Heading::south, false), (Cell{0, 1}));
  EXPECT_EQ(ahead(Heading::east, true), (Cell{1, 0}));
  EXPECT_EQ(ahead(Heading::west, false), (Cell{-1, 0}));
}

TEST(Heading, HasTheAngleOfItsStep) {
  for (const bool y_up : {false, true}) {
    for (const Heading heading : kAllHeadings) {
      const double angle = radians_of(heading, y_up);
      const Cell step = ahead(heading, y_up);
      EXPECT_NEAR(std::cos(angle), step.x, 1e-15);
      EXPECT_NEAR(std::sin(angle), step.y, 1e-15);
    }
  }
}

TEST(Heading, IsTheNearestOne) {
  for (const bool y_up : {false, true}) {
    for (const Heading heading : kAllHeadings) {
      for (const double off : {-0.78, -0.3, 0.0, 0.78}) {
        for (const double turns : {-4 * kPi, 0.0, 2 * kPi}) {
          EXPECT_EQ(nearest_heading(radians_of(heading, y_up) + off + turns, y_up), heading) << off;
        }
      }
    }
  }
}

TEST(Heading, IsExactOrNone) {
  for (const bool y_up : {false, true}) {
    for (const Heading heading : kAllHeadings) {
      const double angle = radians_of(heading, y_up);
      EXPECT_EQ(exact_heading(angle, y_up), heading);
      EXPECT_EQ(exact_heading(angle + 1e-9, y_up), std::nullopt);
      EXPECT_EQ(exact_heading(angle + 2 * kPi, y_up), std::nullopt);
    }
  }
}

TEST(Heading, IsReadFromLettersAndNumbers) {
  EXPECT_EQ(parse_heading("N"), Heading::north);
  EXPECT_EQ(parse_heading("w"), Heading::west);
  EXPECT_EQ(parse_heading("2"), Heading::east);
  EXPECT_EQ(parse_heading("3"), Heading::south);
  for (const char* text : {"", "4", "-1", "NE", "any", "E ", "0.5"}) {
    EXPECT_EQ(parse_heading(text), std::nullopt) << text;
  }
  for (const Heading heading : kAllHeadings) EXPECT_EQ(parse_heading(to_string(heading)), heading);
}

}  // namespace
}  // namespace wend
