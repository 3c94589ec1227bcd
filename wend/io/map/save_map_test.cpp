#include "wend/io/map/save_map.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "wend/io/io_test_support.hpp"
#include "wend/io/map/image_map.hpp"
#include "wend/io/map/load_map.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;

constexpr Frame kSavedFrame = {0.05, {-1, -2, 0.5}, true, true};

Grid<CellState> any_cells(std::initializer_list<CellState> states) {
  Grid<CellState> cells(*rc::gen::inRange(1, 30), *rc::gen::inRange(1, 30));
  const std::vector<CellState> choices(states);
  for (int y = 0; y < cells.height(); ++y) {
    for (CellState& cell : cells.row(y)) cell = *rc::gen::elementOf(choices);
  }
  return cells;
}

GridMap saved_and_loaded(const GridMap& map, const fs::path& file) {
  const auto saved = save_map(map, file);
  if (!saved) RC_FAIL(error_of(saved));
  const auto loaded = load_map(file);
  if (!loaded) RC_FAIL(error_of(loaded));
  return loaded->map;
}

TEST(SaveMap, KnowsThePictureOfSomethingElse) {
  const TemporaryFolder folder;
  const GridMap map = *make_grid_map(Grid<CellState>(2, 2, CellState::free));
  EXPECT_EQ(unrelated_picture(folder / "floor.yaml"), std::nullopt);
  folder.write("floor.png", "a photograph");
  EXPECT_EQ(unrelated_picture(folder / "floor.yaml"), folder / "floor.png");
  EXPECT_EQ(unrelated_picture(folder / "floor.yml"), folder / "floor.png");
  EXPECT_EQ(unrelated_picture(folder / "floor.png"), std::nullopt) << "that is the file itself";
  EXPECT_EQ(unrelated_picture(folder / "floor.map"), std::nullopt);
  ASSERT_TRUE(save_map(map, folder / "floor.yaml"));
  EXPECT_EQ(unrelated_picture(folder / "floor.yaml"), std::nullopt) << "it is its own now";
  EXPECT_EQ(unrelated_picture(folder / "floor.yml"), folder / "floor.png");
  for (const char* const other : {"not: a map.yaml", "image: walls.png\nresolution: 1\n"}) {
    folder.write("floor.yaml", other);
    EXPECT_EQ(unrelated_picture(folder / "floor.yaml"), folder / "floor.png") << other;
  }
}

RC_GTEST_PROP(SaveMap, EveryFormatGivesTheCellsBack, ()) {
  const GridMap map = *make_grid_map(any_cells({CellState::free, CellState::occupied}));
  const TemporaryFolder folder;
  for (const std::string name : {"m.map", "m.txt", "m.grid", "m.png", "m.pgm"}) {
    RC_ASSERT(cells_of(saved_and_loaded(map, folder / name)) == cells_of(map));
  }
}

RC_GTEST_PROP(SaveMap, GridsAndPicturesKeepUnknownCells, ()) {
  const GridMap map =
      *make_grid_map(any_cells({CellState::free, CellState::occupied, CellState::unknown}));
  const TemporaryFolder folder;
  for (const std::string name : {"m.txt", "m.png", "m.pgm"}) {
    RC_ASSERT(cells_of(saved_and_loaded(map, folder / name)) == cells_of(map));
  }
}

RC_GTEST_PROP(SaveMap, AYamlKeepsTheFrameToo, ()) {
  const GridMap map = *make_grid_map(
      any_cells({CellState::free, CellState::occupied, CellState::unknown}), kSavedFrame);
  const TemporaryFolder folder;
  const GridMap again = saved_and_loaded(map, folder / "m.yaml");
  RC_ASSERT(cells_of(again) == cells_of(map));
  RC_ASSERT(again.frame() == kSavedFrame);
}

RC_GTEST_PROP(SaveMap, AYamlKeepsScaledTerrain, ()) {
  const auto cells = any_cells({CellState::free, CellState::occupied, CellState::unknown});
  Grid<double> terrain(cells.width(), cells.height(), 1);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (cells[{x, y}] == CellState::free) {
        terrain[{x, y}] = scaled_terrain(4, *rc::gen::inRange(0, 101));
      }
    }
  }
  const GridMap map = *make_grid_map(cells, kSavedFrame, terrain);
  const TemporaryFolder folder;
  const GridMap again = saved_and_loaded(map, folder / "m.yaml");
  RC_ASSERT(cells_of(again) == cells_of(map));
  RC_ASSERT(again.terrain() == map.terrain());
}

class SaveMapFile : public testing::Test {
 protected:
  std::string saved(const GridMap& map, const std::string& name) {
    const auto result = save_map(map, folder_ / name);
    return result ? bytes_of(folder_ / name) : error_of(result);
  }

  TemporaryFolder folder_;
};

GridMap with_a_corner(const Frame& frame) {
  Grid<CellState> cells(2, 2);
  cells[{0, 0}] = CellState::occupied;
  return *make_grid_map(cells, frame);
}

GridMap with_terrain(double terrain) {
  return *make_grid_map(Grid<CellState>(1, 1), {}, Grid<double>(1, 1, terrain));
}

TEST_F(SaveMapFile, ComesOutAsTheMapIsDrawn) {
  EXPECT_EQ(saved(with_a_corner({}), "down.txt"), "#.\n..\n");
  EXPECT_EQ(saved(with_a_corner(kSavedFrame), "up.txt"), "..\n#.\n");
  EXPECT_THAT(saved(with_a_corner(kSavedFrame), "up.pgm"),
              EndsWith(std::string("\xFE\xFE\x00\xFE", 4)));
}

TEST_F(SaveMapFile, AYamlHasItsImageBesideIt) {
  EXPECT_EQ(saved(with_a_corner(kSavedFrame), "m.yaml"),
            "image: \"m.png\"\nmode: trinary\nresolution: 0.05\norigin: [-1, -2, 0.5]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_TRUE(fs::exists(folder_ / "m.png"));
}

TEST_F(SaveMapFile, AYamlOfAMapWithYDownIsDrawnTheSameAndStartsAtTheOrigin) {
  ASSERT_TRUE(save_map(with_a_corner({}), folder_ / "m.yaml"));
  const auto loaded = load_map(folder_ / "m.yaml");
  EXPECT_EQ(cells_of(loaded->map), "..\n#.\n");
  EXPECT_EQ(loaded->map.frame(), (Frame{1, {}, true, true}));
  EXPECT_THAT(saved(with_a_corner({1, {1, 2, 0}, false, true}), "n.yaml"),
              EndsWith("a ROS map.yaml cannot hold an origin of a map with y down"));
}

TEST_F(SaveMapFile, RefusesWhatTheFormatCannotHoldAndWritesNothing) {
  const GridMap unknown = *make_grid_map(Grid<CellState>(1, 1, CellState::unknown));
  EXPECT_THAT(saved(unknown, "m.map"),
              HasSubstr("a MovingAI map cannot hold unknown cells (1 cell);"));
  EXPECT_THAT(saved(with_terrain(2), "m.map"), HasSubstr("a MovingAI map cannot hold terrain;"));
  EXPECT_THAT(saved(with_terrain(1.5), "m.txt"), HasSubstr("cannot hold the terrain 1.5"));
  EXPECT_THAT(saved(with_terrain(2), "m.png"), EndsWith("; a ROS map.yaml or a text grid can"));
  EXPECT_THAT(saved(with_terrain(9), "m.yaml"), HasSubstr("cannot hold the terrain 9"));
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(SaveMapFile, AFailureLeavesTheOldFileAlone) {
  folder_.write("m.map", "old");
  EXPECT_FALSE(save_map(with_terrain(2), folder_ / "m.map"));
  EXPECT_EQ(bytes_of(folder_ / "m.map"), "old");
}

TEST_F(SaveMapFile, OtherNamesAreRefused) {
  EXPECT_THAT(
      saved(with_a_corner({}), "m.jpg"),
      EndsWith(
          "m.jpg: unknown map extension '.jpg'; expected .yaml, .yml, .map, .txt, .grid, .png, "
          ".pgm or .pnm"));
}

TEST(SavedFiles, AreAllThatSaveMapWrites) {
  for (const std::string name : {"m.map", "m.txt", "m.grid", "m.png", "m.pgm", "m.pnm", "m.yaml"}) {
    const TemporaryFolder folder;
    ASSERT_TRUE(save_map(with_a_corner({}), folder / name));
    std::set<fs::path> written;
    for (const auto& entry : fs::directory_iterator(folder.path())) written.insert(entry.path());
    const auto told = saved_files(folder / name);
    EXPECT_EQ(written, std::set<fs::path>(told.begin(), told.end())) << name;
  }
}

}  // namespace
}  // namespace wend
