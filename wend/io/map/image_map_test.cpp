#include "wend/io/map/image_map.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/testing/whole_image.hpp"
#include "wend/base/random.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/map/save_map.hpp"

namespace wend {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

GreyImage image_of(int width, std::vector<std::uint16_t> values, int maximum = 255) {
  GreyImage image;
  image.width = width;
  image.height = static_cast<int>(values.size()) / width;
  image.maximum = maximum;
  image.values = std::move(values);
  return image;
}

ImageMeaning meaning_of(ImageMode mode) {
  ImageMeaning meaning;
  meaning.mode = mode;
  return meaning;
}

/// The values of one row of pixels as cells.
std::string cells_in(std::vector<std::uint16_t> values, const ImageMeaning& meaning) {
  const int width = static_cast<int>(values.size());
  const std::string cells =
      cells_of(map_from_image(image_of(width, std::move(values)), meaning, {}));
  return cells.substr(0, cells.size() - 1);
}

TEST(ImageMap, DarkIsOccupiedLightIsFreeAndBetweenIsUnknown) {
  // p = 1, .65098, .647, .19608, .192, 0
  EXPECT_EQ(cells_in({0, 89, 90, 205, 206, 255}, {}), "##??..");
}

TEST(ImageMap, NegateSwapsDarkAndLight) {
  ImageMeaning negated;
  negated.negate = true;
  EXPECT_EQ(cells_in({0, 49, 50, 165, 166, 255}, negated), "..??##");
}

TEST(ImageMap, BothThresholdsAreIncluded) {
  ImageMeaning meaning;
  meaning.occupied_threshold = 0.6;
  meaning.free_threshold = 0.2;
  EXPECT_EQ(cells_in({102, 103, 203, 204}, meaning), "#??.");
}

TEST(ImageMap, PixelsAreReadOnTheirOwnScale) {
  EXPECT_EQ(cells_of(map_from_image(image_of(2, {0, 1}, 1), {}, {})), "#.\n");
  EXPECT_EQ(cells_of(map_from_image(image_of(3, {0, 205 * 257, 65535}, 65535), {}, {})), "#?.\n");
}

TEST(ImageMap, RowZeroIsTheTopOfAnImageAndTheBottomOfARosMap) {
  const GreyImage image = image_of(2, {0, 255, 255, 255});
  EXPECT_EQ(cells_of(map_from_image(image, {}, {})), "#.\n..\n");
  Frame y_up;
  y_up.y_up = true;
  EXPECT_EQ(cells_of(map_from_image(image, {}, y_up)), "..\n#.\n");
}

TEST(ImageMap, TransparentPixelsAreUnknown) {
  GreyImage image = image_of(2, {0, 255, 128, 128});
  image.transparent = {1, 0, 1, 0};
  EXPECT_EQ(cells_of(map_from_image(image, {}, {})), "?.\n??\n");
  const GridMap scaled = map_from_image(image, meaning_of(ImageMode::scale), {});
  EXPECT_EQ(cells_of(scaled), "?.\n?.\n");
  EXPECT_EQ(scaled.terrain({0, 1}), 1);
}

TEST(ImageMap, ScaleTurnsWhatIsBetweenIntoTerrain) {
  const GridMap map = map_from_image(image_of(7, {0, 90, 200, 128, 205, 127, 255}),
                                     meaning_of(ImageMode::scale), {});
  EXPECT_EQ(cells_of(map), "#......\n");
  // Nav2's values 99, 4, 67, 0, 67 become 1 + 4 v/100.
  EXPECT_THAT(map.terrain().values(),
              ElementsAre(1, DoubleEq(4.96), DoubleEq(1.16), DoubleEq(3.68), 1, DoubleEq(3.68), 1));
}

TEST(ImageMap, TheScaleFactorSetsTheDearestTerrain) {
  ImageMeaning meaning = meaning_of(ImageMode::scale);
  meaning.scale_factor = 10;
  EXPECT_THAT(map_from_image(image_of(1, {90}), meaning, {}).terrain({0, 0}), DoubleEq(10.9));
  meaning.scale_factor = 0;
  EXPECT_TRUE(map_from_image(image_of(1, {90}), meaning, {}).uniform_terrain());
}

TEST(ImageMap, AScaledCellIsOccupiedByItsThresholdAndNotByItsRoundedValue) {
  ImageMeaning meaning = meaning_of(ImageMode::scale);
  meaning.occupied_threshold = 1;
  meaning.free_threshold = 0;
  const GridMap map = map_from_image(image_of(2, {0, 1}), meaning, {});
  EXPECT_EQ(cells_of(map), "#.\n");
  EXPECT_EQ(map.terrain({1, 0}), 5);
}

TEST(ImageMap, RawTakesTheGreyValueItself) {
  ImageMeaning meaning = meaning_of(ImageMode::raw);
  meaning.negate = true;
  GreyImage image = image_of(5, {0, 50, 99, 100, 101});
  image.transparent = {0, 1, 0, 0, 0};
  const GridMap map = map_from_image(image, meaning, {});
  EXPECT_EQ(cells_of(map), "...#?\n");
  EXPECT_THAT(map.terrain().values(), ElementsAre(1, 3, DoubleEq(4.96), 1, 1));
}

TEST(ImageMap, RawScalesSixteenBitsToEight) {
  const GridMap map =
      map_from_image(image_of(2, {50 * 257, 100 * 257}, 65535), meaning_of(ImageMode::raw), {});
  EXPECT_EQ(cells_of(map), ".#\n");
  EXPECT_EQ(map.terrain({0, 0}), 3);
}

/// Rows of bytes are read 64 at a time.
TEST(ImageMap, BytesAreReadAsTheSameValuesOfSixteenBits) {
  Random random(8);
  for (int width = 1; width < 200; ++width) {
    ImageMeaning meaning;
    meaning.negate = random.chance(0.3);
    meaning.mode = random.chance(0.3) ? ImageMode::raw : ImageMode::trinary;
    if (random.chance(0.2)) meaning.occupied_threshold = 1;
    std::vector<unsigned char> bytes(static_cast<std::size_t>(width));
    for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random.below(256));
    if (random.chance(0.5)) std::ranges::replace_if(bytes, [](int v) { return v < 210; }, 205);
    const std::vector<std::uint16_t> values(bytes.begin(), bytes.end());
    ImageMapRows narrow(meaning);
    ImageMapRows wide(meaning);
    narrow.begin(width, 2, 255);
    wide.begin(width, 2, 255);
    if (meaning.mode == ImageMode::trinary) {
      ASSERT_TRUE(narrow.add_bytes(bytes));
    } else {
      ASSERT_FALSE(narrow.add_bytes(bytes)) << "terrain takes more than bits";
      narrow.add(values, {});
    }
    narrow.add(values, {});
    wide.add(values, {});
    wide.add(values, {});
    ASSERT_EQ(narrow.greys().darkest, wide.greys().darkest);
    ASSERT_EQ(narrow.greys().brightest, wide.greys().brightest);
    ASSERT_EQ(narrow.greys().saved_unknown, wide.greys().saved_unknown);
    const GridMap map = *narrow.finish({});
    const GridMap expected = *wide.finish({});
    ASSERT_EQ(map.occupied(), expected.occupied());
    ASSERT_EQ(map.unknown(), expected.unknown());
  }
}

TEST(TrinaryImage, HasTheGreysOfMapSavers) {
  Grid<CellState> cells(3, 1);
  cells[{0, 0}] = CellState::occupied;
  cells[{2, 0}] = CellState::unknown;
  EXPECT_THAT(trinary_image(*make_grid_map(cells)).values, ElementsAre(0, 254, 205));
}

TEST(SavedImage, RefusesTerrain) {
  const GridMap map = *make_grid_map(Grid<CellState>(1, 1), {}, Grid<double>(1, 1, 2));
  EXPECT_EQ(error_of(encode_map(map, MapFormat::image_map, "m.png")),
            "an image cannot hold terrain; a ROS map.yaml or a text grid can");
}

TEST(ScaleImage, HoldsEveryScaledTerrain) {
  Grid<double> terrain(101, 1);
  for (int v = 0; v <= 100; ++v) terrain[{v, 0}] = scaled_terrain(4, v);
  const auto image = scale_image(*make_grid_map(Grid<CellState>(101, 1), {}, terrain));
  EXPECT_EQ(map_from_image(image, kScaleMeaning, {}).terrain(), terrain);
}

TEST(SavedScaleImage, RefusesOtherTerrain) {
  const auto with_terrain = [](CellState state, double terrain) {
    const GridMap map =
        *make_grid_map(Grid<CellState>(1, 1, state), {}, Grid<double>(1, 1, terrain));
    return error_of(encode_map(map, MapFormat::map_yaml, "m.yaml"));
  };
  EXPECT_EQ(
      with_terrain(CellState::free, 1.05),
      "a ROS map.yaml cannot hold the terrain 1.05 of cell (0,0), only 1 + 4 v/100 for whole v "
      "up to 5 for free cells");
  EXPECT_NE(with_terrain(CellState::free, 9), "no error");
  EXPECT_NE(with_terrain(CellState::unknown, 2), "no error");
  EXPECT_EQ(with_terrain(CellState::occupied, 9), "no error");
}

}  // namespace
}  // namespace wend
