// The snippets of the headers about costs and masks, compiled and run as they stand there.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <vector>

#include "tests/snippets/snippets.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/load_mask.hpp"
#include "wend/map/masked.hpp"
#include "wend/map/occupancy.hpp"
#include "wend/map/own_costs.hpp"
#include "wend/map/value_edit.hpp"
#include "wend/map/value_rows.hpp"
#include "wend/session/session.hpp"
#include "wend/space/grid/line_cost.hpp"

namespace {

using wend::test::OfficeInWorkingFolder;
using wend::test::report;
using wend::test::reported;

void read_costmap() {
  const std::vector<std::uint8_t> costs{0, 126, 254, 0, 252, 255};
  const wend::Frame frame{.resolution = 0.05, .y_up = true, .metric = true};
  const auto map = wend::map_from_costmap(costs, 3, 2, frame);
  if (!map) return report(map.error().message);
  EXPECT_EQ(map->terrain({1, 0}), 3);
  EXPECT_EQ(map->state({2, 1}), wend::CellState::unknown);
  report("a costmap");
}

TEST(Snippets, OfCostmaps) {
  read_costmap();
  EXPECT_EQ(reported, "a costmap");
}

TEST(Snippets, OfTheDifferenceOfValues) {
  const std::vector<std::int8_t> before{0, 0, 0, 0};
  const std::vector<std::int8_t> after{0, 0, 0, 100};
  const auto found = wend::difference<std::int8_t>({before, 2}, {after, 2});
  const wend::Cell first = found.box.begin;  // (1, 1)
  EXPECT_EQ(first, (wend::Cell{1, 1}));
  EXPECT_EQ(found.cells, 1);
}

TEST(Snippets, OfEditsBetweenValues) {
  const std::vector<std::uint8_t> before{0, 0, 0, 0};
  const std::vector<std::uint8_t> after{0, 254, 0, 0};
  const auto read = [](std::uint8_t cost) { return wend::meaning_of_cost(cost); };
  const wend::MapEdit edit =
      wend::edit_between<std::uint8_t>({before, 2}, {after, 2}, {0, 0}, read);
  const bool changed = !edit.cells.empty() || !edit.states.empty();
  EXPECT_TRUE(changed);
}

void lay_zones(const wend::GridMap& office) {
  const auto zones = wend::load_mask("keepout.yaml");
  if (!zones) return report(zones.error().message);
  const auto map = wend::masked(office, zones->map);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->occupied().count(), office.occupied().count() + 1);

  wend::Session session(*map);
  const wend::MapEdit edit{.states = wend::Grid<wend::CellState>(office.width(), office.height(),
                                                                 wend::CellState::free)};
  const auto zones_here = wend::mask_on_grid_of(office, zones->map);
  session.edit(wend::masked_edit(edit, *zones_here));
  EXPECT_EQ(session.view()->space.map().occupied().count(), 1U);
  report("zones");
}

void lay_mask(const wend::GridMap& office) {
  const auto mask = wend::load_mask("zones.yaml");
  if (!mask) return report(mask.error().message);
  const auto map = wend::masked(office, mask->map);
  EXPECT_TRUE(map);
}

TEST(Snippets, OfMasks) {
  const OfficeInWorkingFolder folder;
  std::ofstream("keepout.yaml")
      << "image: keepout.pgm\nresolution: 0.1\norigin: [0.2, 0.2, 0]\nnegate: 0\n"
         "occupied_thresh: 0.65\nfree_thresh: 0.25\n";
  std::ofstream("keepout.pgm") << "P2 1 1 255\n0\n";
  const wend::GridMap office = wend::load_map("office.yaml")->map;
  lay_zones(office);
  EXPECT_EQ(reported, "zones");
  lay_mask(office);
  EXPECT_EQ(reported, "zones.yaml: cannot be opened: No such file or directory");
}

void add_mud(const wend::GridMap& map) {
  const auto cost_of = [](wend::Cell cell) { return cell.y < 5 ? 3.0 : 1.0; };
  const auto muddy = wend::with_terrain(map, cost_of);
  if (!muddy) return report(muddy.error().message);
  EXPECT_EQ(muddy->terrain({2, 4}), 3);
  EXPECT_EQ(muddy->terrain({2, 5}), 1);
  report("mud");
}

TEST(Snippets, OfLineCosts) {
  const wend::FreeSpace& space = wend::test::open_ground();
  const double cost = wend::line_cost(space, {0, 4}, {3, 6});
  EXPECT_EQ(cost, std::sqrt(13));
}

TEST(Snippets, OfCostsOfOnesOwn) {
  add_mud(wend::test::open_ground().map());
  EXPECT_EQ(reported, "mud");
}

}  // namespace
