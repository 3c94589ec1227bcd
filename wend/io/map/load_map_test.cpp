#include "wend/io/map/load_map.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;

const std::string kMovingAi = "type octile\nheight 1\nwidth 2\nmap\n.@\n";
const std::string kImage = "P2 2 1 255 255 0\n";
const std::string kYaml =
    "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

class LoadMap : public testing::Test {
 protected:
  MapFormat format_of(const std::string& name, const std::string& bytes) {
    const auto loaded = load_map(folder_.write(name, bytes));
    EXPECT_TRUE(loaded) << error_of(loaded);
    if (!loaded) return MapFormat::text_grid;
    EXPECT_EQ(cells_of(loaded->map), ".#\n");
    return loaded->format;
  }

  TemporaryFolder folder_;
};

TEST_F(LoadMap, TellsFormatsByTheirNames) {
  EXPECT_EQ(format_of("m.pgm", kImage), MapFormat::image_map);
  EXPECT_EQ(format_of("m.PNG", kImage), MapFormat::image_map);
  EXPECT_EQ(format_of("m.yaml", kYaml), MapFormat::map_yaml);
  EXPECT_EQ(format_of("m.yml", kYaml), MapFormat::map_yaml);
  EXPECT_EQ(format_of("m.map", kMovingAi), MapFormat::moving_ai_map);
  EXPECT_EQ(format_of("m.txt", "01\n"), MapFormat::text_grid);
  EXPECT_EQ(format_of("m.grid", "01\n"), MapFormat::text_grid);
}

TEST_F(LoadMap, ElseByTheirContent) {
  folder_.write("m.pgm", kImage);
  EXPECT_EQ(format_of("image", kImage), MapFormat::image_map);
  EXPECT_EQ(format_of("moving_ai", kMovingAi), MapFormat::moving_ai_map);
  EXPECT_EQ(format_of("ros", "# a map\n" + kYaml), MapFormat::map_yaml);
}

TEST_F(LoadMap, SkipsAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  folder_.write("m.pgm", kImage);
  EXPECT_EQ(format_of("m.map", mark + kMovingAi), MapFormat::moving_ai_map);
  EXPECT_EQ(format_of("m.txt", mark + "01\n"), MapFormat::text_grid);
  EXPECT_EQ(format_of("m.yaml", mark + kYaml), MapFormat::map_yaml);
  EXPECT_EQ(format_of("moving_ai", mark + kMovingAi), MapFormat::moving_ai_map);
  EXPECT_EQ(format_of("ros", mark + kYaml), MapFormat::map_yaml);
}

TEST_F(LoadMap, NamesWhatItReadsWhenItReadsNothing) {
  EXPECT_THAT(
      error_of(load_map(folder_.write("m.scen", "version 1\n"))),
      EndsWith("m.scen: unknown map format; expected a ROS map.yaml (.yaml, .yml), a MovingAI "
               "map (.map), a text grid (.txt, .grid) or an image (.png, .pgm, .pbm, .ppm, "
               ".pnm, .bmp, .jpg, .jpeg)"));
  EXPECT_THAT(error_of(load_map(folder_.write("nothing", ""))),
              EndsWith("nothing: the file is empty; expected a map"));
  EXPECT_THAT(error_of(load_map(folder_.write("m.bmp", "BM123456"))),
              EndsWith("m.bmp: BMP: the file is truncated"));
  EXPECT_THAT(error_of(load_map(folder_.write("m.jpg", "II*\n    "))),
              EndsWith("m.jpg: unknown image format; expected PNG, PNM (P1 to P6), BMP or JPEG"));
}

TEST_F(LoadMap, ErrorsNameFileAndLine) {
  const auto file = folder_.write("m.map", "type octile\nheight 1\nwidth 2\nmap\n.x\n");
  EXPECT_EQ(error_of(load_map(file)),
            file.string() + ":5: unknown terrain letter 'x' at row 0 column 1");
  EXPECT_EQ(error_of(load_map(folder_ / "missing.map")),
            (folder_ / "missing.map").string() + ": cannot be opened: No such file or directory");
}

TEST_F(LoadMap, ABareImageHasYDownAndCellsOrMetres) {
  const auto file = folder_.write("m.pgm", kImage);
  EXPECT_EQ(load_map(file)->map.frame(), Frame{});
  LoadOptions options;
  options.resolution = 0.05;
  const auto loaded = load_map(file, options);
  EXPECT_EQ(loaded->map.frame(), (Frame{0.05, {}, false, true}));
  EXPECT_THAT(loaded->notes, IsEmpty());
}

TEST_F(LoadMap, SaysThatAResolutionIsNotUsed) {
  LoadOptions options;
  options.resolution = 0.05;
  const auto loaded = load_map(folder_.write("m.map", kMovingAi), options);
  EXPECT_EQ(loaded->map.frame(), Frame{});
  EXPECT_THAT(loaded->notes,
              ElementsAre("resolution option ignored: it applies only to bare images"));
}

TEST_F(LoadMap, ChecksItsOptions) {
  const auto file = folder_.write("m.pgm", kImage);
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    LoadOptions options;
    options.resolution = wrong;
    EXPECT_THAT(error_of(load_map(file, options)),
                EndsWith("the resolution given must be finite and above 0"));
  }
  for (const double wrong : {-1.0, 1e7, std::numeric_limits<double>::quiet_NaN()}) {
    LoadOptions options;
    options.scale_factor = wrong;
    EXPECT_THAT(error_of(load_map(file, options)),
                EndsWith("the scale factor given must be in 0..1e6"));
  }
}

TEST_F(LoadMap, TheScaleFactorReachesTheTerrain) {
  folder_.write("m.pgm", "P2 1 1 255 90\n");
  LoadOptions options;
  options.scale_factor = 10;
  const auto loaded = load_map(folder_.write("m.yaml", kYaml + "mode: scale\n"), options);
  EXPECT_DOUBLE_EQ(loaded->map.terrain({0, 0}), 10.9);
}

TEST(MapFormat, HasANameForPeople) {
  EXPECT_EQ(to_string(MapFormat::map_yaml), "ROS map.yaml");
  EXPECT_EQ(to_string(MapFormat::moving_ai_map), "MovingAI");
  EXPECT_EQ(to_string(MapFormat::text_grid), "text grid");
  EXPECT_EQ(to_string(MapFormat::image_map), "image");
}

}  // namespace
}  // namespace wend
