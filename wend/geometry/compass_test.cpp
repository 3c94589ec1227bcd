#include "wend/geometry/compass.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr Frame kYDown{};
constexpr Frame kYUp{.y_up = true};
constexpr std::array<Frame, 2> kBothWays{kYDown, kYUp};

/// Converts a grid step to a step on a page, where up is positive.
Cell seen(Cell step, const Frame& frame) { return {step.x, frame.y_up ? step.y : -step.y}; }

TEST(Compass, NamesDirectionsAsAPageShowsThem) {
  EXPECT_EQ(name_of(Direction::plus_y, kYDown), "down");
  EXPECT_EQ(name_of(Direction::plus_y, kYUp), "up");
  EXPECT_EQ(name_of(Direction::minus_x_minus_y, kYDown), "up_left");
  EXPECT_EQ(name_of(Direction::minus_x_minus_y, kYUp), "down_left");
  EXPECT_EQ(name_of(Direction::plus_x, kYUp), "right");
  for (const Frame& frame : kBothWays) {
    for (int i = 0; i < kDirections; ++i) {
      const auto direction = static_cast<Direction>(i);
      const Cell step = seen(wend::step({}, direction), frame);
      const std::string_view name = name_of(direction, frame);
      EXPECT_EQ(name.find("up") != name.npos, step.y > 0) << name;
      EXPECT_EQ(name.find("down") != name.npos, step.y < 0) << name;
      EXPECT_EQ(name.find("right") != name.npos, step.x > 0) << name;
      EXPECT_EQ(name.find("left") != name.npos, step.x < 0) << name;
    }
  }
}

TEST(Compass, NorthIsUpOnAPage) {
  for (const Frame& frame : kBothWays) {
    for (const Heading heading : kAllHeadings) {
      const Cell step = seen(ahead(heading), frame);
      const std::string_view expected = step.y > 0   ? "N"
                                        : step.y < 0 ? "S"
                                        : step.x > 0 ? "E"
                                                     : "W";
      EXPECT_EQ(letter_of(heading, frame), expected);
    }
  }
}

TEST(Compass, NamesSegments) {
  for (const Frame& frame : kBothWays) {
    const std::string plus = frame.y_up ? "LEFT" : "RIGHT";
    const std::string minus = frame.y_up ? "RIGHT" : "LEFT";
    const auto name = [&](const Pose& from, const Pose& to) {
      return name_of(segment_between(from, to), frame);
    };
    EXPECT_EQ(name({0, 0, 0}, {0, 0, 1}), "TURN_" + plus);
    EXPECT_EQ(name({0, 0, 0}, {0, 0, -1}), "TURN_" + minus);
    EXPECT_EQ(name({0, 0, 1}, {-1, 1, 1}), "SIDE_" + plus);
    EXPECT_EQ(name({0, 0, 0}, {-1, -1, 0}), "SIDE_" + minus);
    EXPECT_EQ(name({0, 0, 0}, {2, 0, 0}), "FWD");
    EXPECT_EQ(name({0, 0, 0}, {-2, 0, 0}), "REV");
    EXPECT_EQ(name({0, 0, 0}, {1, 1, kPi / 2}), "FWD_" + plus);
    EXPECT_EQ(name({0, 0, 0}, {1, -1, -kPi / 2}), "FWD_" + minus);
    EXPECT_EQ(name({0, 0, 0}, {-1, 1, -kPi / 2}), "REV_" + plus);
    EXPECT_EQ(name({0, 0, 0}, {-1, -1, kPi / 2}), "REV_" + minus);
  }
}

TEST(Compass, MirrorsBackAndForth) {
  for (int i = 0; i < kDirections; ++i) {
    const auto direction = static_cast<Direction>(i);
    const Cell step = wend::step({}, direction);
    EXPECT_EQ(wend::step({}, mirrored(direction)), (Cell{step.x, -step.y}));
    EXPECT_EQ(mirrored(mirrored(direction)), direction);
  }
  for (const Heading heading : kAllHeadings) {
    EXPECT_EQ(mirrored(mirrored(heading)), heading);
    EXPECT_EQ(radians_of(mirrored(heading)), normalized_angle(-radians_of(heading)));
  }
}

TEST(Compass, ReadsHeadingsFromLettersAndNumbers) {
  EXPECT_EQ(parse_heading("N", kYDown), Heading::minus_y);
  EXPECT_EQ(parse_heading("N", kYUp), Heading::plus_y);
  EXPECT_EQ(parse_heading("0", kYUp), Heading::plus_y);
  EXPECT_EQ(parse_heading("w", kYDown), Heading::minus_x);
  EXPECT_EQ(parse_heading("2", kYUp), Heading::plus_x);
  EXPECT_EQ(parse_heading("3", kYDown), Heading::plus_y);
  for (const char* text : {"", "4", "-1", "NE", "any", "E ", "0.5"}) {
    EXPECT_EQ(parse_heading(text, kYDown), std::nullopt) << text;
  }
  for (const Frame& frame : kBothWays) {
    for (const Heading heading : kAllHeadings) {
      EXPECT_EQ(parse_heading(letter_of(heading, frame), frame), heading);
    }
  }
}

}  // namespace
}  // namespace wend
