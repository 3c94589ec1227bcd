#include "wend/io/map/losses.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "conformance/random_map.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/save_map.hpp"

namespace wend {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A name for every format and extension.
std::vector<std::string> saved_names() {
  std::vector<std::string> names = map_extensions(MapUse::save);
  for (std::string& name : names) name.insert(0, "m");
  return names;
}

/// A frame that differs from the default in some fields, often in only one.
Frame any_frame(Random& random) {
  Frame frame;
  if (random.chance(0.3)) frame.resolution = 0.01 + random.uniform();
  if (random.chance(0.3)) frame.y_up = true;
  if (random.chance(0.3)) frame.metric = true;
  if (random.chance(0.2)) frame.origin = {random.uniform(), -random.uniform(), 0};
  if (random.chance(0.2)) frame.origin.heading = random.uniform();
  return frame;
}

/// Terrain that all, some or none of the formats can hold; also under obstacles.
Grid<double> any_terrain(Random& random, int width, int height) {
  if (random.chance(0.5)) return {};
  Grid<double> terrain(width, height, 1);
  const int kind = random.between(0, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (random.chance(0.5)) continue;
      terrain[{x, y}] = kind == 0   ? random.between(1, 10)
                        : kind == 1 ? 1 + 4.0 * random.between(0, 100) / 100
                        : kind == 2 ? 1 + 10 * random.uniform()
                                    : random.between(1, 5);
    }
  }
  return terrain;
}

GridMap any_map() {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const int width = random.between(1, 12);
  const int height = random.between(1, 12);
  Grid<double> terrain = any_terrain(random, width, height);
  Grid<CellState> states = test::random_states(random, width, height);
  if (random.chance(0.5)) {  // a map whose obstacles have no terrain
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (!terrain.empty() && terrain[{x, y}] != 1) states[{x, y}] = CellState::free;
      }
    }
  }
  return *make_grid_map(states, any_frame(random), std::move(terrain));
}

GridMap reloaded(const GridMap& map, const std::filesystem::path& file) {
  const auto saved = save_map(map, file);
  if (!saved) RC_FAIL(error_of(saved));
  const auto loaded = load_map(file);
  if (!loaded) RC_FAIL(error_of(loaded));
  return loaded->map;
}

RC_GTEST_PROP(Losses, AreToldIfAndOnlyIfAnotherMapComesBack, ()) {
  const GridMap map = any_map();
  const TemporaryFolder folder;
  for (const std::string& name : saved_names()) {
    const MapFormat format = *saved_format(name);
    const GridMap again = reloaded(nearest_map(map, format), folder / name);
    RC_ASSERT(losses(map, format).empty() == same_map(map, again));
  }
}

RC_GTEST_PROP(NearestMap, IsWhatComesBack, ()) {
  const GridMap map = any_map();
  const TemporaryFolder folder;
  for (const std::string& name : saved_names()) {
    const GridMap nearest = nearest_map(map, *saved_format(name));
    RC_ASSERT(same_map(nearest, reloaded(nearest, folder / name)));
    RC_ASSERT(losses(nearest, *saved_format(name)).empty());
  }
}

RC_GTEST_PROP(NearestMap, IsDrawnLikeTheMap, ()) {
  const GridMap map = any_map();
  for (const MapFormat format : {MapFormat::map_yaml, MapFormat::text_grid, MapFormat::image_map}) {
    RC_ASSERT(test::drawing_of(nearest_map(map, format)) == test::drawing_of(map));
  }
}

/// No terrain value of the format is nearer.
RC_GTEST_PROP(NearestMap, RoundsToTheNearestTerrain, ()) {
  const double terrain = 1 + *rc::gen::inRange(0, 12000) / 1000.0;
  const GridMap map = *make_grid_map(Grid<CellState>(1, 1), {}, Grid<double>(1, 1, terrain));
  const double in_text = nearest_map(map, MapFormat::text_grid).terrain({0, 0});
  for (int held = 1; held <= 9; ++held) {
    RC_ASSERT(std::abs(in_text - terrain) <= std::abs(held - terrain));
  }
  const double in_yaml = nearest_map(map, MapFormat::map_yaml).terrain({0, 0});
  for (int v = 0; v <= 100; ++v) {
    RC_ASSERT(std::abs(in_yaml - terrain) <= std::abs(1 + 0.04 * v - terrain) + 1e-9);
  }
}

RC_GTEST_PROP(SaveMap, RefusesAMapThatWouldComeBackWithOtherFreeOrUnknownCells, ()) {
  const GridMap map = any_map();
  const TemporaryFolder folder;
  for (const std::string& name : saved_names()) {
    if (!save_map(map, folder / name)) continue;
    const GridMap again = load_map(folder / name)->map;
    RC_ASSERT(test::drawing_of(again) == test::drawing_of(map));
  }
}

/// A map of four cells in a column, drawn from the top: free at a cost of 1.5, free at 12, unknown
/// at 2, occupied.
GridMap odd_map(Frame frame) {
  Grid<CellState> states(1, 4, CellState::free);
  Grid<double> terrain(1, 4, 1);
  const auto row = [&](int from_top) { return frame.y_up ? 3 - from_top : from_top; };
  terrain[{0, row(0)}] = 1.49;
  terrain[{0, row(1)}] = 12;
  states[{0, row(2)}] = CellState::unknown;
  terrain[{0, row(2)}] = 2;
  states[{0, row(3)}] = CellState::occupied;
  return *make_grid_map(states, frame, terrain);
}

constexpr Frame kRosFrame = {0.05, {-1, 2.5, 0.5}, true, true};

TEST(Losses, OfAMovingAiMap) {
  EXPECT_THAT(
      losses(odd_map(kRosFrame), MapFormat::moving_ai_map),
      ElementsAre(
          "unknown cells become occupied (1 cell): a MovingAI map cannot hold unknown cells",
          "terrain is lost (3 cells): a MovingAI map cannot hold terrain, all cells cost the same",
          "the resolution of 0.05 m a cell is lost: the unit of a MovingAI map is the cell",
          "the origin [-1, 2.5, 0.5] is lost: a MovingAI map holds no origin",
          "y points down, as in every MovingAI map: cell (x, y) becomes (x, 3 - y)"));
}

TEST(Losses, OfATextGrid) {
  EXPECT_THAT(
      losses(odd_map({}), MapFormat::text_grid),
      ElementsAre("terrain above 9 becomes 9 (1 cell): the limit of a text grid",
                  "terrain is rounded, by at most 0.49 (1 cell): a text grid holds whole numbers",
                  "the terrain of occupied and unknown cells is lost (1 cell): a text grid holds "
                  "terrain only for free cells"));
  EXPECT_THAT(losses(odd_map({0.5, {}, false, false}), MapFormat::text_grid).back(),
              "the cell size 0.5 is lost: in a text grid it is 1");
}

TEST(Losses, OfAMapYaml) {
  EXPECT_THAT(
      losses(odd_map(kRosFrame), MapFormat::map_yaml),
      ElementsAre("terrain above 5 becomes 5 (1 cell): the limit of a ROS map.yaml; a text grid "
                  "holds up to 9",
                  "terrain is rounded, by at most 0.01 (1 cell): a ROS map.yaml holds "
                  "1 + 4 v/100 for whole v",
                  "the terrain of occupied and unknown cells is lost (1 cell): a ROS map.yaml "
                  "holds terrain only for free cells"));
}

TEST(Losses, OfAFrameWithYDownInAMapYaml) {
  const GridMap map = *make_grid_map(Grid<CellState>(1, 5), {0.5, {1, 0, 0}, false, false});
  EXPECT_THAT(
      losses(map, MapFormat::map_yaml),
      ElementsAre(
          "the unit becomes the metre, as in a ROS map.yaml: a cell is 0.5 m wide",
          "the origin [1, 0, 0] is lost: a ROS map.yaml holds an origin only where y was up before",
          "y points up, as in every ROS map.yaml: cell (x, y) becomes (x, 4 - y)"));
}

TEST(Losses, OfAnImage) {
  const GridMap map = *make_grid_map(Grid<CellState>(1, 1), {0.5, {}, false, true});
  EXPECT_THAT(
      losses(map, MapFormat::image_map),
      ElementsAre("the resolution of 0.5 m a cell is lost: the unit of an image is the cell"));
}

TEST(Losses, AreNoneWhereTheFormatHoldsTheMap) {
  const GridMap plain = *make_grid_map(Grid<CellState>(3, 2));
  for (const MapFormat format :
       {MapFormat::moving_ai_map, MapFormat::text_grid, MapFormat::image_map}) {
    EXPECT_THAT(losses(plain, format), IsEmpty());
  }
  EXPECT_THAT(losses(*make_grid_map(Grid<CellState>(3, 2), kRosFrame), MapFormat::map_yaml),
              IsEmpty());
}

}  // namespace
}  // namespace wend
