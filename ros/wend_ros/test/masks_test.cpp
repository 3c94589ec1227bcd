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

TEST(Masks, LieOverEveryMap) {
  const std::string zone = written_mask("zone", "trinary", "255 0 255 255");
  const std::string slow = written_mask("slow", "raw", "0 0 50 0");
  const auto map = Masks::of({"keepout:" + zone, "speed:" + slow}).over(room());
  ASSERT_TRUE(map) << map.error().message;
  EXPECT_EQ(map->state({1, 0}), wend::CellState::occupied);
  EXPECT_EQ(map->terrain({2, 0}), 2);
  EXPECT_EQ(map->state({1, 1}), wend::CellState::free);
  EXPECT_TRUE(Masks().over(room())->uniform_terrain());
}

TEST(Masks, ThatCannotBeReadLeaveNoMap) {
  const auto none = Masks::of({"keepout:none.yaml"}).over(room());
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("mask keepout:none.yaml: "), std::string::npos);
  const auto wrong = Masks::of({"speed:"}).over(room());
  ASSERT_FALSE(wrong);
  const auto no_map = Masks::of({}).over(wend::failure(wend::Status::invalid_map, "no map"));
  EXPECT_EQ(no_map.error().message, "no map");
}

}  // namespace
}  // namespace wend_ros
