// The colours of every style, as people with and without colour-blindness see them. Differences
// are Euclidean ones in CIELAB (Delta E 76): 2 is just visible side by side.

#include "wend/render/style.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace wend {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

struct Vision {
  std::string_view name;
  Matrix matrix;  // on linear RGB
};

// Machado, Oliveira, Fernandes: A Physiologically-based Model for Simulation of Color Vision
// Deficiency, 2009, at full severity.
constexpr std::array<Vision, 3> kVisions{{
    {"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868},
       {0.114503, 0.786281, 0.099216},
       {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968},
       {0.280085, 0.672501, 0.047413},
       {-0.011820, 0.042940, 0.968881}}}},
}};

constexpr Matrix kXyzOfRgb{{{0.4124564, 0.3575761, 0.1804375},
                            {0.2126729, 0.7151522, 0.0721750},
                            {0.0193339, 0.1191920, 0.9503041}}};
constexpr Vector kWhitePoint{0.95047, 1, 1.08883};

Vector product(const Matrix& matrix, const Vector& vector) {
  Vector result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t i = 0; i < 3; ++i) result[row] += matrix[row][i] * vector[i];
  }
  return result;
}

double linear(double part) {
  return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

/// L, a and b.
Vector lab(const Colour& colour, const Vision& vision) {
  Vector rgb =
      product(vision.matrix, {linear(colour.red), linear(colour.green), linear(colour.blue)});
  for (double& part : rgb) part = std::clamp(part, 0.0, 1.0);
  const Vector xyz = product(kXyzOfRgb, rgb);
  Vector f{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = xyz[i] / kWhitePoint[i];
    f[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double difference(const Colour& a, const Colour& b, const Vision& vision) {
  const Vector p = lab(a, vision);
  const Vector q = lab(b, vision);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double lightness(const Colour& colour) { return lab(colour, kVisions[0])[0]; }

struct Named {
  std::string name;
  Colour colour;
};

std::vector<Named> roles(const Style& style, std::initializer_list<CellRole> wanted) {
  std::vector<Named> named;
  for (const CellRole role : wanted) named.push_back({std::string(describe(role)), style.of(role)});
  return named;
}

/// The kinds of cells that one picture may show: those of a search, or of two components.
std::vector<std::vector<Named>> pictures(const Style& style) {
  const std::vector<Named> map{{"free", style.free},
                               {"obstacle", style.occupied},
                               {"unknown", style.unknown},
                               {"too close", style.too_close}};
  std::vector<std::vector<Named>> pictures{
      roles(style, {CellRole::expanded, CellRole::frontier, CellRole::current}),
      roles(style, {CellRole::start_component, CellRole::goal_component})};
  for (auto& picture : pictures) picture.insert(picture.end(), map.begin(), map.end());
  return pictures;
}

std::vector<Named> marks(const Style& style) {
  return {{"path", style.path},
          {"start", style.start},
          {"goal", style.goal},
          {"narrowest", style.narrowest}};
}

std::vector<Named> lines(const Style& style) {
  std::vector<Named> named;
  for (const LineRole role : {LineRole::planned, LineRole::smoothed, LineRole::driven}) {
    named.push_back({std::string(describe(role)), style.of(role)});
  }
  return named;
}

void expect_apart(const Named& a, const Named& b, double least, std::string_view style) {
  for (const Vision& vision : kVisions) {
    EXPECT_GE(difference(a.colour, b.colour, vision), least)
        << a.name << " and " << b.name << ", style " << style << ", " << vision.name;
  }
}

void expect_all_apart(const std::vector<Named>& colours, double least, std::string_view style) {
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) expect_apart(colours[i], colours[k], least, style);
  }
}

/// The style in which a car's plan is drawn.
Style yard_style(StyleName name) {
  Scene scene{.space = *make_free_space(*make_grid_map(Grid<CellState>(1, 1)))};
  scene.places = corners_of(scene.space);
  return style_for(scene, style_of(name));
}

Colour rough(const Style& style, double multiplier) {
  return mixed(style.slightly_rough, style.very_rough, roughness(multiplier));
}

std::vector<Named> rough_roads(const Style& style) {
  return {{"rough by 1.5", rough(style, 1.5)},
          {"rough by 2", rough(style, 2)},
          {"rough by 3", rough(style, 3)},
          {"rough by 5", rough(style, 5)},
          {"rough by 10", rough(style, 10)}};
}

std::vector<Named> yard_marks(const Style& style) {
  std::vector<Named> named = marks(style);
  named.push_back({"driven in reverse", style.reverse});
  return named;
}

constexpr double kCellsApart = 6;
constexpr double kMarksApart = 10;

TEST(Style, TellsApartAllCellsOfOnePicture) {
  for (const auto& [name, value] : choice_names(StyleName{})) {
    for (const auto& picture : pictures(style_of(value))) {
      expect_all_apart(picture, kCellsApart, name);
    }
  }
}

TEST(Style, TellsMarksFromTheCellsUnderThem) {
  for (const auto& [name, value] : choice_names(StyleName{})) {
    for (const auto& picture : pictures(style_of(value))) {
      for (const Named& cell : picture) {
        for (const Named& mark : marks(style_of(value)))
          expect_apart(mark, cell, kMarksApart, name);
      }
    }
  }
}

/// Greys are told apart by width and dashes too, but lines lie on each other.
TEST(Style, TellsLinesFromEachOtherAndFromTheMapUnderThem) {
  for (const auto& [name, value] : choice_names(StyleName{})) {
    const Style style = style_of(value);
    expect_all_apart(lines(style), kMarksApart, name);
    for (const Named& line : lines(style)) {
      for (const Named& cell :
           {Named{"free", style.free}, Named{"obstacle", style.occupied},
            Named{"unknown", style.unknown}, Named{"too close", style.too_close}}) {
        expect_apart(line, cell, kMarksApart, name);
      }
    }
  }
}

TEST(Style, DrawsPlannedRedSmoothedGreenAndDrivenBlue) {
  for (const StyleName name : {StyleName::light, StyleName::dark}) {
    const LineColours& lines = style_of(name).lines;
    EXPECT_GT(lines.planned.red, 2 * std::max(lines.planned.green, lines.planned.blue));
    EXPECT_GT(lines.smoothed.green, 1.4 * std::max(lines.smoothed.red, lines.smoothed.blue));
    EXPECT_GT(lines.driven.blue, 1.6 * std::max(lines.driven.red, lines.driven.green));
  }
}

TEST(Style, TellsApartAllCellsOfAYard) {
  for (const StyleName name : {StyleName::light, StyleName::dark}) {
    const Style style = yard_style(name);
    for (const auto& picture : pictures(style)) {
      expect_all_apart(picture, kCellsApart, choice_name(name));
      for (const Named& cell : picture) {
        for (const Named& road : rough_roads(style)) {
          expect_apart(road, cell, kCellsApart, choice_name(name));
        }
      }
    }
  }
}

/// A search uses many greys, so rough roads share some of them.
TEST(Style, PrintsObstaclesRoughRoadsAndThePathOfAYardApart) {
  const Style style = yard_style(StyleName::print);
  for (const Named& road : rough_roads(style)) {
    expect_all_apart(
        {road, {"free", style.free}, {"obstacle", style.occupied}, {"path", style.path}},
        kCellsApart, "print");
  }
}

TEST(Style, TellsTheWayThroughAYardFromAllThatLiesUnderIt) {
  for (const auto& [name, value] : choice_names(StyleName{})) {
    const Style style = yard_style(value);
    std::vector<Named> under = rough_roads(style);
    for (const auto& picture : pictures(style)) {
      under.insert(under.end(), picture.begin(), picture.end());
    }
    for (const Named& cell : under) {
      for (const Named& mark : yard_marks(style)) expect_apart(mark, cell, kMarksApart, name);
    }
  }
}

TEST(Style, DrawsObstaclesOfAYardRedAndRoughRoadsTheMoreYellowTheRougher) {
  const Vision& normal = kVisions[0];
  for (const StyleName name : {StyleName::light, StyleName::dark}) {
    const Style style = yard_style(name);
    const auto [lightness, red, yellow] = lab(style.occupied, normal);
    EXPECT_GT(red, 45) << choice_name(name) << lightness;
    EXPECT_LT(yellow, red) << choice_name(name);
    double before = 0;
    for (const Named& road : rough_roads(style)) {
      const Vector colour = lab(road.colour, normal);
      EXPECT_LT(std::abs(colour[1]), 0.5 * colour[2]) << road.name << choice_name(name);
      EXPECT_GT(colour[2], before) << road.name << choice_name(name);
      before = colour[2];
    }
  }
}

TEST(Style, KeepsItsColoursWithoutACarAndBesideHeat) {
  Scene scene{.space = *make_free_space(*make_grid_map(Grid<CellState>(1, 1)))};
  const Style style;
  EXPECT_EQ(style_for(scene, style).occupied, style.occupied);
  scene.places = corners_of(scene.space);
  EXPECT_EQ(style_for(scene, style).occupied, style.yard_occupied);
  scene.heatmap = {"cost", Grid<double>(1, 1)};
  EXPECT_EQ(style_for(scene, style).occupied, style.occupied);
}

TEST(Style, TellsMarksApartByColourExceptInPrint) {
  for (const StyleName name : {StyleName::light, StyleName::dark}) {
    expect_all_apart(marks(style_of(name)), kMarksApart, choice_name(name));
    expect_all_apart(yard_marks(yard_style(name)), kMarksApart, choice_name(name));
  }
}

/// A mark is seen by itself, or else by its halo.
TEST(Style, ShowsMarksAndObstaclesOnEveryHeat) {
  constexpr double kSeen = 15;
  for (const auto& [name, value] : choice_names(StyleName{})) {
    const Style style = style_of(value);
    for (int percent = 0; percent <= 100; ++percent) {
      const Colour heat = style.heat(percent / 100.0);
      for (const Vision& vision : kVisions) {
        EXPECT_GE(difference(style.occupied, heat, vision), kSeen) << name << percent;
        for (const Named& mark : marks(style)) {
          const double by_halo = std::min(difference(style.halo, heat, vision),
                                          difference(style.halo, mark.colour, vision));
          EXPECT_GE(std::max(difference(mark.colour, heat, vision), by_halo), kSeen)
              << mark.name << " at " << percent << " %, style " << name << ", " << vision.name;
        }
      }
    }
  }
}

TEST(Style, GetsFurtherFromThePageWithHeatInEvenStepsOfLightness) {
  constexpr int kSteps = 64;
  for (const auto& [name, value] : choice_names(StyleName{})) {
    const Style style = style_of(value);
    const double whole = std::abs(lightness(style.heat(1)) - lightness(style.heat(0)));
    EXPECT_GE(whole, 40) << name;
    for (int i = 0; i < kSteps; ++i) {
      const double here = lightness(style.heat(static_cast<double>(i) / kSteps));
      const double next = lightness(style.heat(static_cast<double>(i + 1) / kSteps));
      const double step = value == StyleName::dark ? next - here : here - next;
      EXPECT_GT(step, 0.5 * whole / kSteps) << name << " " << i;
      EXPECT_LT(step, 1.5 * whole / kSteps) << name << " " << i;
    }
  }
}

TEST(Style, TakesTheNearerEndForSharesOutOfRange) {
  const Style style;
  EXPECT_EQ(style.heat(0), style.heat_colours.front());
  EXPECT_EQ(style.heat(1), style.heat_colours.back());
  EXPECT_EQ(style.heat(-3), style.heat(0));
  EXPECT_EQ(style.heat(7), style.heat(1));
}

TEST(Style, PrintsInGreysWithALightnessForEveryRole) {
  constexpr double kGreysApart = 4.5;
  const Style style = style_of(StyleName::print);
  std::vector<Named> colours =
      roles(style, {CellRole::expanded, CellRole::frontier, CellRole::current,
                    CellRole::start_component, CellRole::goal_component});
  colours.insert(colours.end(), {{"free", style.free},
                                 {"obstacle", style.occupied},
                                 {"unknown", style.unknown},
                                 {"too close", style.too_close},
                                 {"path", style.path}});
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const Colour& grey = colours[i].colour;
    EXPECT_TRUE(grey.red == grey.green && grey.green == grey.blue) << colours[i].name;
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GE(std::abs(lightness(grey) - lightness(colours[k].colour)), kGreysApart)
          << colours[i].name << " and " << colours[k].name;
    }
  }
}

TEST(Style, IsReadableOnItsPage) {
  for (const auto& [name, value] : choice_names(StyleName{})) {
    const Style style = style_of(value);
    EXPECT_GE(std::abs(lightness(style.ink) - lightness(style.page)), 60) << name;
    EXPECT_EQ(lightness(style.page) < 50, value == StyleName::dark) << name;
    EXPECT_GT(lightness(style.page), 5) << "dark is not black";
  }
}

TEST(Style, KnowsItsNames) {
  EXPECT_EQ(choice_name(StyleName::light), "light");
  EXPECT_EQ(choice_name(StyleName::dark), "dark");
  EXPECT_EQ(choice_name(StyleName::print), "print");
}

TEST(Colour, TurnsIntoBytesAndBack) {
  for (const std::uint32_t rgb : {0x000000U, 0xFFFFFFU, 0x123456U, 0xFE0180U}) {
    EXPECT_EQ(rgb_of(colour_from(rgb)), rgb);
  }
}

}  // namespace
}  // namespace wend
