// Sweeps over real maps: after many edits, the free space is that of the edited map, bit by bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "conformance/random_edit.hpp"
#include "tests/testing/build_paths.hpp"
#include "wend/io/map/load_map.hpp"

namespace wend::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> map_files() {
  std::vector<fs::path> files;
  if (data_folder().empty()) return files;
  for (const auto& [folder, extension] :
       {std::pair{"nine", ".map"}, {"grids", ".map"}, {"ros", ".yaml"}}) {
    const fs::path root = data_folder() / folder;
    if (!fs::exists(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (entry.path().extension() == extension) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What a sensor sees in a box: some cells differ from the map.
MapEdit random_sweep(Random& random, const GridMap& map) {
  const CellBox box = random_box_on(random, map, 200);
  const double share = one_of<double>(random, std::array{0.0, 0.01, 0.05, 0.5});
  MapEdit edit{.corner = box.begin, .states = Grid<CellState>(box.width(), box.height())};
  for (const Cell cell : every_cell(edit.states)) {
    const CellState state = map.state({box.begin.x + cell.x, box.begin.y + cell.y});
    edit.states[cell] = random.chance(share) ? random_state(random, 0.5) : state;
  }
  return edit;
}

void expect_space_of_edited_map(const FreeSpace& space) {
  const FreeSpace fresh = *make_free_space(space.map(), space.options());
  ASSERT_TRUE(space.passable() == fresh.passable());
  ASSERT_TRUE(space.costs() == fresh.costs());
  for (const Adjacency adjacency : {Adjacency::edges, Adjacency::edges_and_corners}) {
    ASSERT_EQ(space.components().sizes(adjacency), fresh.components().sizes(adjacency));
  }
  for (const Cell cell : every_cell(space)) {
    ASSERT_EQ(space.squared_half_cell_clearance(cell, 100),
              fresh.squared_half_cell_clearance(cell, 100));
    ASSERT_EQ(space.components().component(cell, Adjacency::edges),
              fresh.components().component(cell, Adjacency::edges));
  }
}

void sweep(const fs::path& file, std::uint64_t seed) {
  SCOPED_TRACE(testing::Message() << file << ", seed " << seed);
  const auto loaded = load_map(file.string());
  if (!loaded) return;  // a mask or a broken file: other tests say so
  Random random(seed);
  FreeSpaceOptions robot = random_robot(random, loaded->map.frame().resolution);
  if (random.chance(0.5)) robot.footprint = Footprint::disc(4 * loaded->map.frame().resolution);
  FreeSpace space = *make_free_space(loaded->map, robot);
  for (int i = 0; i < 12; ++i) {
    if (random.chance(0.3)) space.components().count(Adjacency::edges);
    ASSERT_TRUE(space.edit(random_sweep(random, space.map())));
  }
  expect_space_of_edited_map(space);
}

TEST(MapEditData, SweepsOverRealMaps) {
  const auto files = map_files();
  if (files.empty()) GTEST_SKIP() << "no data";
  for (std::size_t i = 0; i < files.size(); i += 6) {
    sweep(files[i], i);
    if (HasFatalFailure()) return;
  }
}

TEST(MapEditData, SweepsOverAllRealMapsLongRun) {
  const auto files = map_files();
  if (files.empty()) GTEST_SKIP() << "no data";
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    for (const fs::path& file : files) {
      sweep(file, seed);
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace wend::test
