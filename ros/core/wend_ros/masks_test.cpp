#include "wend_ros/masks.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace wend_ros {
namespace {

wend::GridMap room() {
  return *wend::make_grid_map(wend::Grid<wend::CellState>(4, 2, wend::CellState::free),
                              {.resolution = 0.5, .y_up = true, .metric = true});
}

std::string written_mask(const std::string& name, const std::string& mode,
                         const std::string& pixels) {
  const std::string file = testing::TempDir() + "wend_ros_" + name;
  std::ofstream(file + ".pgm") << "P2 4 1 255 " << pixels << "\n";
  std::ofstream(file + ".yaml") << "image: " << file << ".pgm\nmode: " << mode
                                << "\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
                                << "occupied_thresh: 0.65\nfree_thresh: 0.2\n";
  return file + ".yaml";
}

TEST(Masks, LieOverEveryMapAndItsEdits) {
  Masks masks = Masks::of({"keepout:" + written_mask("zone", "trinary", "255 0 255 255"),
                           "speed:" + written_mask("slow", "raw", "0 0 50 0")});
  EXPECT_TRUE(masks.faults().empty());
  auto map = masks.lay_over(room());
  ASSERT_TRUE(map) << map.error().message;
  EXPECT_EQ(map->state({1, 0}), wend::CellState::occupied);
  EXPECT_EQ(map->terrain({2, 0}), 2);
  EXPECT_EQ(map->state({1, 1}), wend::CellState::free);
  const wend::MapEdit edit{.states = wend::Grid<wend::CellState>(4, 2, wend::CellState::free),
                           .terrain = wend::Grid<double>(4, 2, 3)};
  ASSERT_TRUE(map->edit(masks.over(edit)));
  EXPECT_EQ(map->state({1, 0}), wend::CellState::occupied) << "an update does not free a zone";
  EXPECT_EQ(map->terrain({2, 0}), 6);
  EXPECT_EQ(map->terrain({2, 1}), 3);
}

TEST(Masks, SayWhatIsProbablyNotMeant) {
  const Masks masks = Masks::of({"keepout:" + written_mask("grey", "trinary", "255 0 205 255")});
  ASSERT_EQ(masks.notes().size(), 1U);
  EXPECT_NE(masks.notes().front().find("grey 205"), std::string::npos);
}

TEST(Masks, ThatAreNoneChangeNothing) {
  Masks masks;
  EXPECT_TRUE(masks.empty());
  EXPECT_TRUE(masks.lay_over(room())->uniform_terrain());
  EXPECT_EQ(masks.over({.cells = {{{1, 1}, wend::CellState::occupied}}}).cells.size(), 1U);
}

TEST(Masks, ThatCannotBeReadLeaveNoMap) {
  Masks masks = Masks::of({"keepout:none.yaml", "speed:"});
  ASSERT_EQ(masks.faults().size(), 2U);
  EXPECT_NE(masks.faults().front().find("mask keepout:none.yaml: "), std::string::npos);
  const auto none = masks.lay_over(room());
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, masks.faults().front());
}

}  // namespace
}  // namespace wend_ros
