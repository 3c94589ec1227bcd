// The colours of the cells of a scene.

#include <gtest/gtest.h>

#include <limits>

#include "wend/render/style.hpp"
#include "wend/render/terminal/text_map_test.hpp"

namespace wend {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Grid<double> row(const std::vector<double>& values) {
  Grid<double> grid(static_cast<int>(values.size()), 1);
  std::copy(values.begin(), values.end(), grid.row(0).begin());
  return grid;
}

TEST(CellPaints, DrawsLaterRolesOverEarlierOnesButNeverOverObstacles) {
  Scene scene{.space = *make_free_space(map_of({"..#?."}))};
  scene.marked = {{CellRole::expanded, marked_of({"****-"}, '*')},
                  {CellRole::frontier, marked_of({"-+++-"}, '+')}};
  const Style style;
  const CellPaints paints(scene, style);
  EXPECT_EQ((paints[{0, 0}].colour), style.expanded);
  EXPECT_EQ((paints[{1, 0}].colour), style.frontier);
  EXPECT_EQ((paints[{2, 0}].colour), style.occupied);
  EXPECT_EQ((paints[{3, 0}].colour), style.frontier);
  EXPECT_EQ((paints[{4, 0}].colour), style.free);
  EXPECT_EQ(role_of(scene, {0, 0}), CellRole::expanded);
  EXPECT_EQ(role_of(scene, {1, 0}), CellRole::frontier);
  EXPECT_EQ(role_of(scene, {4, 0}), std::nullopt);
  EXPECT_EQ(roles_in(scene), (std::vector{CellRole::expanded, CellRole::frontier}));
}

TEST(CellPaints, SpreadHeatFromTheLeastToTheGreatestFiniteValue) {
  Scene scene{.space = *make_free_space(map_of({"...#?...."}))};
  scene.heatmap = {"cost", row({-2, 0, 2, 900, 1, kInfinity, kNaN, 0, -kInfinity})};
  scene.heatmap->values[{3, 0}] = 2;  // on an obstacle: it stays one
  scene.marked = {{CellRole::current, marked_of({"-------@-"}, '@')}};
  const Style style;
  const CellPaints paints(scene, style);
  EXPECT_EQ((paints[{0, 0}].colour), style.heat(0));
  EXPECT_EQ((paints[{1, 0}].colour), style.heat(0.5));
  EXPECT_EQ((paints[{2, 0}].colour), style.heat(1));
  EXPECT_EQ((paints[{3, 0}].colour), style.occupied);
  EXPECT_EQ((paints[{4, 0}].colour), style.heat(0.75)) << "over unknown";
  EXPECT_EQ((paints[{5, 0}].colour), style.free) << "infinite";
  EXPECT_EQ((paints[{6, 0}].colour), style.free) << "not a number";
  EXPECT_EQ((paints[{7, 0}].colour), style.current) << "a role over heat";
  EXPECT_EQ((paints[{8, 0}].colour), style.free);
}

TEST(CellPaints, DrawRoughGroundOnlyWhereNoHeatIs) {
  Scene scene{.space = *make_free_space(map_of({"29"}))};
  const Style style;
  EXPECT_NE((CellPaints(scene, style)[{1, 0}].colour), style.free);
  scene.heatmap = {"cost", row({1, kNaN})};
  EXPECT_EQ((CellPaints(scene, style)[{1, 0}].colour), style.free);
}

/// Neither hides the other, nor looks like it.
TEST(CellPaints, ShowRoughGroundUnderARole) {
  Scene scene{.space = *make_free_space(map_of({"29.9#"}))};
  scene.marked = {{CellRole::expanded, marked_of({"***-*"}, '*')}};
  const Style style;
  const CellPaints paints(scene, style);
  EXPECT_EQ((paints[{0, 0}].colour), style.of(CellRole::expanded, 2));
  EXPECT_EQ((paints[{1, 0}].colour), style.of(CellRole::expanded, 9));
  EXPECT_NE((paints[{0, 0}].colour), style.expanded);
  EXPECT_EQ(paints.stripes({0, 0}), (Stripes{style.expanded, style.rough(2)}));
  EXPECT_EQ(paints.stripes({1, 0}), (Stripes{style.expanded, style.rough(9)}));
  EXPECT_EQ(paints.stripes({2, 0}), std::nullopt) << "not rough";
  EXPECT_EQ(paints.stripes({3, 0}), std::nullopt) << "no role";
  EXPECT_EQ(paints.stripes({4, 0}), std::nullopt) << "an obstacle";
  const Style print = style_of(StyleName::print);
  EXPECT_EQ(CellPaints(scene, print).stripes({3, 0}), (Stripes{print.rough(9), print.stripe(9)}))
      << "greys alone do not tell";
  scene.heatmap = {"cost", row({1, 2, 3, 4, 5})};
  EXPECT_EQ(CellPaints(scene, style).stripes({0, 0}), std::nullopt) << "beside heat";
}

TEST(CellPaints, DrawAConstantLayerAsTheLeastAndAnEmptyOneNotAtAll) {
  Scene scene{.space = *make_free_space(map_of({".."}))};
  const Style style;
  scene.heatmap = {"cost", row({7, 7})};
  EXPECT_EQ((CellPaints(scene, style)[{1, 0}].colour), style.heat(0));
  scene.heatmap = {"cost", row({kNaN, kInfinity})};
  EXPECT_EQ((CellPaints(scene, style)[{1, 0}].colour), style.free);
}

TEST(CellPaints, HeedAGivenRange) {
  Scene scene{.space = *make_free_space(map_of({"..."}))};
  scene.heatmap = {"cost", row({0, 5, 30}), HeatRange{0, 10}};
  const Style style;
  const CellPaints paints(scene, style);
  EXPECT_EQ((paints[{1, 0}].colour), style.heat(0.5));
  EXPECT_EQ((paints[{2, 0}].colour), style.heat(1));
}

}  // namespace
}  // namespace wend
