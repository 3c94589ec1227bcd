#include "wend/io/map/load_mask.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/testing/build_paths.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/map/masked.hpp"

namespace wend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string mask_yaml(const std::string& mode, const std::string& image = "m.pgm") {
  return "image: " + image + "\nmode: " + mode +
         "\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 1.0\n"
         "free_thresh: 0.0\n";
}

std::vector<double> costs_of(const GridMap& map) {
  std::vector<double> costs;
  for (int x = 0; x < map.width(); ++x) costs.push_back(map.terrain({x, 0}));
  return costs;
}

class LoadMask : public testing::Test {
 protected:
  /// A mask whose values are 0, 10, 50, 99, 100 and one that is not known, in a row.
  std::string raw_mask() {
    folder_.write("m.pgm", "P2 6 1 255 0 10 50 99 100 255\n");
    return folder_.write("m.yaml", mask_yaml("raw"));
  }

  std::string complaint(const std::string& file, const MaskReading& reading) {
    const auto mask = load_mask(file, reading);
    EXPECT_FALSE(mask);
    return mask ? std::string() : mask.error().message;
  }

  TemporaryFolder folder_;
};

constexpr MaskReading kSpeedMask{.kind = MaskKind::speed, .speed = {}};

TEST_F(LoadMask, ReadsKeepOutZonesAndTheirCosts) {
  const auto mask = load_mask(raw_mask());
  ASSERT_TRUE(mask) << mask.error().message;
  EXPECT_EQ(cells_of(mask->map), "....#?\n");
  EXPECT_THAT(costs_of(mask->map), ElementsAre(1, 1.4, 3, 1 + 4 * .99, 1, 1));
  const auto grid = load_mask(folder_.write("m.txt", ".3#?\n"));
  ASSERT_TRUE(grid) << "any format";
  EXPECT_EQ(grid->map.terrain({1, 0}), 3);
}

TEST_F(LoadMask, ReadsSpeedLimitsInPercent) {
  const auto mask = load_mask(raw_mask(), kSpeedMask);
  ASSERT_TRUE(mask) << mask.error().message;
  EXPECT_EQ(cells_of(mask->map), ".....?\n") << "a speed mask blocks nothing";
  EXPECT_THAT(costs_of(mask->map), ElementsAre(1, 10, 2, 100.0 / 99, 1, 1));
  EXPECT_THAT(mask->files, testing::SizeIs(2));
}

TEST_F(LoadMask, ReadsSpeedLimitsInMetresPerSecond) {
  const MaskReading reading{.kind = MaskKind::speed,
                            .speed = {.base = 0, .multiplier = 0.02, .top_speed = 1}};
  const auto mask = load_mask(raw_mask(), reading);
  ASSERT_TRUE(mask) << mask.error().message;
  EXPECT_THAT(costs_of(mask->map), ElementsAre(1, 5, 1, 1, 1, 1));
}

TEST_F(LoadMask, SaysWhatASpeedMaskHasToBe) {
  folder_.write("m.pgm", "P2 2 1 255 0 255\n");
  const std::string trinary = folder_.write("t.yaml", mask_yaml("trinary"));
  EXPECT_EQ(complaint(trinary, kSpeedMask),
            trinary +
                ": mode: trinary has no speed limits; a speed mask is a ROS map.yaml with "
                "mode: scale or mode: raw");
  EXPECT_THAT(complaint(folder_ / "m.pgm", kSpeedMask), HasSubstr("an image has no speed limits"));
  EXPECT_THAT(complaint(folder_.write("m.txt", "23\n"), kSpeedMask),
              HasSubstr("a text grid has no speed limits"));
}

TEST_F(LoadMask, RefusesWhatCannotBeRead) {
  for (const MaskKind kind : {MaskKind::keepout, MaskKind::speed}) {
    const MaskReading reading{.kind = kind, .speed = {}};
    EXPECT_THAT(complaint(folder_ / "none.yaml", reading), HasSubstr("none.yaml"));
    folder_.write("cut.pgm", "P5 600 300 255\nabc");
    EXPECT_THAT(complaint(folder_.write("cut.yaml", mask_yaml("scale", "cut.pgm")), reading),
                HasSubstr("cut.pgm"));
    EXPECT_THAT(complaint(folder_.write("half.yaml", mask_yaml("raw").substr(0, 40)), reading),
                HasSubstr("half.yaml"));
    EXPECT_THAT(complaint(folder_.write("empty.yaml", ""), reading), HasSubstr("empty"));
  }
  const MaskReading never{.kind = MaskKind::speed, .speed = {.top_speed = -1}};
  EXPECT_THAT(complaint(raw_mask(), never), HasSubstr("top_speed"));
}

/// What a mask of the command line is read as: "speed 100 -1 none file".
std::string spec_text(const std::string& text) {
  const auto spec = parse_mask_spec(text);
  if (!spec) return spec.error().message;
  const SpeedScale& speed = spec->reading.speed;
  if (spec->reading.kind == MaskKind::keepout) return "keepout " + spec->file.string();
  const std::string top = speed.top_speed ? std::to_string(*speed.top_speed) : "none";
  return "speed " + std::to_string(speed.base) + " " + std::to_string(speed.multiplier) + " " +
         top + " " + spec->file.string();
}

TEST(MaskSpecs, NameAKindItsOptionsAndAFile) {
  EXPECT_EQ(spec_text("zones.yaml"), "keepout zones.yaml");
  EXPECT_EQ(spec_text("keepout:zones.yaml"), "keepout zones.yaml");
  EXPECT_EQ(spec_text("keepout:speed:a"), "keepout speed:a");
  EXPECT_EQ(spec_text("speed:a:b.yaml"), "speed 0.000000 1.000000 none a:b.yaml");
  EXPECT_EQ(spec_text("speed:multiplier=-1:base=100:s.yaml"),
            "speed 100.000000 -1.000000 none s.yaml");
  EXPECT_EQ(spec_text("speed:top_speed=1.5:s.yaml"), "speed 0.000000 1.000000 1.500000 s.yaml");
  EXPECT_EQ(spec_text("other:zones.yaml"), "keepout other:zones.yaml");
}

TEST(MaskSpecs, SayWhatIsWrong) {
  const std::string no_file = "a mask needs a file: keepout:FILE or speed:FILE";
  for (const char* text : {"", "keepout:", "speed:", "speed:base=3:"}) {
    EXPECT_EQ(spec_text(text), no_file) << text;
  }
  EXPECT_EQ(spec_text("speed:base=x:a.yaml"),
            "base of a speed mask is 'x': a finite number expected");
  EXPECT_EQ(spec_text("speed:top_speed=inf:a.yaml"),
            "top_speed of a speed mask is 'inf': a finite number expected");
}

/// The depot of Nav2 with its masks, on one grid.
class DepotMasks : public testing::Test {
 protected:
  void SetUp() override {
    if (test::data_folder().empty()) GTEST_SKIP() << "WEND_DATA is not set";
  }

  static std::filesystem::path data(const std::string& name) {
    return test::data_folder() / "ros" / "nav2" / name;
  }

  /// The grey values of a binary PGM, from the top row down, read without the library.
  static std::vector<int> pixels(const std::string& name) {
    std::ifstream stream(data(name), std::ios::binary);
    std::string line;
    std::vector<int> header;
    std::getline(stream, line);
    while (header.size() < 3) {
      std::getline(stream, line);
      if (line.starts_with('#')) continue;
      std::istringstream words(line);
      for (int word = 0; words >> word;) header.push_back(word);
    }
    std::vector<int> values;
    for (char byte = 0; stream.get(byte);) values.push_back(static_cast<unsigned char>(byte));
    EXPECT_EQ(values.size(),
              static_cast<std::size_t>(header[0]) * static_cast<std::size_t>(header[1]));
    return values;
  }

  static std::size_t pixel_of(const GridMap& map, Cell cell) {
    return static_cast<std::size_t>(map.height() - 1 - cell.y) *
               static_cast<std::size_t>(map.width()) +
           static_cast<std::size_t>(cell.x);
  }
};

TEST_F(DepotMasks, BlockTheirZonesAndNothingElse) {
  const GridMap depot = load_map(data("depot.yaml"))->map;
  const auto made = masked(depot, load_mask(data("depot_keepout.yaml"))->map);
  ASSERT_TRUE(made) << made.error().message;
  const std::vector<int> grey = pixels("depot_keepout.pgm");
  int zone = 0;
  for (const Cell cell : every_cell(depot)) {
    const double occupancy = (255 - grey[pixel_of(depot, cell)]) / 255.0;
    const bool kept_out = occupancy >= 0.65;
    zone += kept_out ? 1 : 0;
    ASSERT_EQ(made->state(cell), kept_out ? CellState::occupied : depot.state(cell));
  }
  EXPECT_GT(zone, 1000);
  EXPECT_TRUE(made->uniform_terrain());
}

TEST_F(DepotMasks, MakeSlowCellsCostTheirTime) {
  const GridMap depot = load_map(data("depot.yaml"))->map;
  const auto made = masked(depot, load_mask(data("depot_speed.yaml"), kSpeedMask)->map);
  ASSERT_TRUE(made) << made.error().message;
  const std::vector<int> grey = pixels("depot_speed.pgm");
  int slow = 0;
  for (const Cell cell : every_cell(depot)) {
    const double percent = std::round(100 * (255 - grey[pixel_of(depot, cell)]) / 255.0);
    const bool limited = percent > 0 && percent < 100;
    slow += limited ? 1 : 0;
    ASSERT_DOUBLE_EQ(made->terrain(cell), limited ? 100 / percent : 1);
    ASSERT_EQ(made->state(cell), depot.state(cell));
  }
  EXPECT_GT(slow, 1000);
}

}  // namespace
}  // namespace wend
