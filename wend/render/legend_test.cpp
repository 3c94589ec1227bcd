#include "wend/render/legend.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

std::vector<std::string> labels_of(const Scene& scene) {
  std::vector<std::string> labels;
  for (const LegendItem& item : legend_of(scene, {})) labels.push_back(item.label);
  return labels;
}

TEST(Legend, ExplainsAllThatOccurs) {
  Scene scene{.space = *make_free_space(map_of({"#..2..?"}), {.footprint = Footprint::disc(1)})};
  scene.start = centre_of({3, 0});
  scene.goals = {centre_of({4, 0})};
  scene.path = Path({{3, 0}, {4, 0}});
  scene.narrowest = centre_of({3, 0});
  scene.arrows.emplace(7, 1, Direction::minus_x);
  scene.heatmap = {"cost", Grid<double>(7, 1, 3.0)};
  scene.marked = {{CellRole::frontier, marked_of({"....*.."}, '*')},
                  {CellRole::expanded, marked_of({"...*..."}, '*')}};
  EXPECT_EQ(labels_of(scene),
            (std::vector<std::string>{"cost", "start", "goal", "narrowest", "path", "way to move",
                                      "expanded", "frontier", "too close", "unknown"}));
  scene.heatmap.reset();
  EXPECT_EQ(labels_of(scene), (std::vector<std::string>{
                                  "start", "goal", "narrowest", "path", "way to move", "expanded",
                                  "expanded, rough", "frontier", "too close", "rough", "unknown"}));
}

TEST(Legend, TellsHowACarDrivesThroughAYard) {
  Scene scene{.space = *make_free_space(map_of({"#2.", "..."}))};
  scene.places = corners_of(scene.space);
  scene.path = Path::through({{1, 1, 0}, {2, 1, 0}, {1, 1, 0}});
  scene.start = scene.path.poses().front();
  EXPECT_EQ(labels_of(scene), (std::vector<std::string>{"start", "driven ahead", "in reverse",
                                                        "obstacle", "rough road"}));
  EXPECT_EQ(legend_of(scene, {}).back().colour, Style{}.rough(3));
  scene.path = Path::through({{1, 1, 0}});
  EXPECT_EQ(labels_of(scene), (std::vector<std::string>{"start", "obstacle", "rough road"}));
}

TEST(Legend, NamesARoleOnRoughGroundBesideBoth) {
  Scene scene{.space = *make_free_space(map_of({"3...3"}))};
  scene.marked = {{CellRole::expanded, marked_of({"**---"}, '*')},
                  {CellRole::frontier, marked_of({"--+--"}, '+')}};
  EXPECT_EQ(labels_of(scene),
            (std::vector<std::string>{"expanded", "expanded, rough", "frontier", "rough"}));
  const LegendItem striped = legend_of(scene, {})[1];
  EXPECT_EQ(striped.colour, Style{}.of(CellRole::expanded, 3));
  EXPECT_EQ(striped.stripes, (Stripes{Style{}.expanded, Style{}.rough(3)}));
  EXPECT_FALSE(legend_of(scene, {}).back().stripes);
  const Style print = style_of(StyleName::print);
  EXPECT_EQ(legend_of(scene, print).back().stripes, (Stripes{print.rough(3), print.stripe(3)}));
}

TEST(Legend, LeavesOutWhatDoesNotOccur) {
  Scene scene{.space = *make_free_space(map_of({"#.."}))};
  scene.path = Path({{1, 0}});
  scene.arrows.emplace(3, 1);
  scene.heatmap = {"cost", Grid<double>(3, 1, std::numeric_limits<double>::infinity())};
  scene.marked = {{CellRole::frontier, BitGrid(3, 1)}};
  EXPECT_TRUE(labels_of(scene).empty());
}

}  // namespace
}  // namespace wend
