#include "wend/render/legend.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "wend/render/text_map_test.hpp"

namespace wend {
namespace {

std::vector<std::string> labels_of(const Scene& scene) {
  std::vector<std::string> labels;
  for (const LegendItem& item : legend_of(scene, {})) labels.push_back(item.label);
  return labels;
}

TEST(Legend, ExplainsAllThatOccurs) {
  Scene scene{.space = FreeSpace(map_of({"#..2..?"}), {.robot_radius = 1})};
  scene.start = centre_of({3, 0});
  scene.goals = {centre_of({4, 0})};
  scene.path = Path({{3, 0}, {4, 0}});
  scene.narrowest = centre_of({3, 0});
  scene.arrows.emplace(7, 1, Direction::left);
  scene.heatmap = {"cost", Grid<double>(7, 1, 3.0)};
  scene.marked = {{CellRole::frontier, marked_of({"....*.."}, '*')},
                  {CellRole::expanded, marked_of({"...*..."}, '*')}};
  EXPECT_EQ(labels_of(scene),
            (std::vector<std::string>{"cost", "start", "goal", "narrowest", "path", "way to move",
                                      "expanded", "frontier", "too close", "unknown"}));
  scene.heatmap.reset();
  EXPECT_EQ(labels_of(scene),
            (std::vector<std::string>{"start", "goal", "narrowest", "path", "way to move",
                                      "expanded", "frontier", "too close", "rough", "unknown"}));
}

TEST(Legend, LeavesOutWhatDoesNotOccur) {
  Scene scene{.space = FreeSpace(map_of({"#.."}))};
  scene.path = Path({{1, 0}});
  scene.arrows.emplace(3, 1);
  scene.heatmap = {"cost", Grid<double>(3, 1, std::numeric_limits<double>::infinity())};
  scene.marked = {{CellRole::frontier, BitGrid(3, 1)}};
  EXPECT_TRUE(labels_of(scene).empty());
}

}  // namespace
}  // namespace wend
