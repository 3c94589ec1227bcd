// docs/colours.md against the colours that pictures have.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "bench/plot/plot_style.hpp"
#include "tests/testing/build_paths.hpp"
#include "wend/render/style.hpp"

namespace wend {
namespace {

using testing::HasSubstr;

std::string page() {
  std::ifstream stream(test::source_folder() / "docs/colours.md");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string hex(std::uint32_t rgb) { return fmt::format("`#{:06X}`", rgb); }

struct Thing {
  std::string name;
  Colour Style::* colour;
};

TEST(ColoursPage, ListsTheColoursOfEveryStyle) {
  const std::vector<Thing> things{
      {"free", &Style::free},
      {"obstacle", &Style::occupied},
      {"obstacle in a yard that a car drives over", &Style::yard_occupied},
      {"unknown", &Style::unknown},
      {"too close for the robot", &Style::too_close},
      {"rough ground, the least", &Style::slightly_rough},
      {"rough ground, ten times and more", &Style::very_rough},
      {"expanded", &Style::expanded},
      {"frontier", &Style::frontier},
      {"being expanded", &Style::current},
      {"start's component", &Style::start_component},
      {"goal's component", &Style::goal_component},
      {"path; driven ahead; possible path (dashed)", &Style::path},
      {"driven in reverse (dashed)", &Style::reverse},
      {"start", &Style::start},
      {"goal", &Style::goal},
      {"narrowest place; nearest free cell; collision", &Style::narrowest},
      {"way to move", &Style::arrows},
      {"page", &Style::page},
      {"text", &Style::ink}};
  const std::string listed = page();
  const auto row = [](const std::string& name, auto&& colour_of) {
    std::string text = "| " + name + " |";
    for (const StyleName style : {StyleName::light, StyleName::dark, StyleName::print}) {
      text += " " + hex(rgb_of(colour_of(style_of(style)))) + " |";
    }
    return text;
  };
  for (const Thing& thing : things) {
    EXPECT_THAT(listed, HasSubstr(row(thing.name,
                                      [&](const Style& style) { return style.*thing.colour; })));
  }
  for (const auto& [name, role] :
       {std::pair("planned, before it was smoothed (dashed)", LineRole::planned),
        std::pair("smoothed", LineRole::smoothed),
        std::pair("driven by a robot", LineRole::driven)}) {
    EXPECT_THAT(listed,
                HasSubstr(row(name, [role = role](const Style& style) { return style.of(role); })));
  }
}

TEST(ColoursPage, ListsTheColoursOfPlots) {
  const std::string text = page();
  for (const std::string name : {"astar, p",
                                 "dijkstra, p_moving",
                                 "jps, pid",
                                 "hub_labels, pure_pursuit",
                                 "stanley",
                                 "boost-astar",
                                 "greedy",
                                 "bfs",
                                 "dfs",
                                 "random_walk",
                                 "car",
                                 "theta_star",
                                 "lazy_theta_star",
                                 "lattice",
                                 "alt",
                                 "replanner",
                                 "d_star_lite",
                                 "hybrid_astar",
                                 "any_angle",
                                 "ara_star",
                                 "euclidean_labels",
                                 "others"}) {
    const std::vector<std::string> first{name.substr(0, name.find(','))};
    const std::size_t colour =
        name == "others" ? kLightPlot.names.size() - 1 : plot_colours_of(first).front();
    EXPECT_THAT(text, HasSubstr("| " + name + " | " + hex(kLightPlot.names[colour]) + " | " +
                                hex(kDarkPlot.names[colour]) + " |"));
  }
}

/// What a possible path has, a path has.
TEST(ColoursPage, SaysThatPathsHaveOneColour) {
  for (const StyleName name : {StyleName::light, StyleName::dark, StyleName::print}) {
    EXPECT_EQ(style_of(name).of(LineRole::possible), style_of(name).path);
  }
}

}  // namespace
}  // namespace wend
