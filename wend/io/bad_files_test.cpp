// The malformed and odd files of the shared data, each with its verdict: reject, accept or either.

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "tests/testing/build_paths.hpp"
#include "tests/testing/whole_image.hpp"
#include "wend/io/image/grey_image.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/query/scenario.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

struct BadFile {
  std::string file;
  std::string verdict;
  std::string expected;
};

void PrintTo(const BadFile& bad, std::ostream* out) { *out << bad.file << ": " << bad.expected; }

fs::path bad_folder() { return test::data_folder() / "bad"; }

/// The rows of expected.tsv that are about maps, images and scenarios; one row without a file
/// where there is no data, so that the test shows up as skipped.
std::vector<BadFile> bad_files() {
  std::vector<BadFile> files;
  std::istringstream table(bytes_of(bad_folder() / "expected.tsv"));
  for (std::string line; std::getline(table, line);) {
    std::istringstream columns(line);
    BadFile bad;
    std::getline(columns, bad.file, '\t');
    std::getline(columns, bad.verdict, '\t');
    std::getline(columns, bad.expected);
    const std::string folder = bad.file.substr(0, bad.file.find('/'));
    if (folder == "map" || folder == "yaml" || folder == "img" || folder == "scen") {
      files.push_back(bad);
    }
  }
  if (files.empty()) files.push_back({"no_data", "skip", ""});
  return files;
}

/// The error that a user sees for this file, "no error" if it loads. Scenarios are for the
/// 5x4 map ok.map.
std::string error_for(const std::string& file) {
  const fs::path path = bad_folder() / file;
  if (path.extension() != ".scen") return error_of(load_map(path));
  const auto scenario = load_scenario(path);
  if (!scenario) return error_of(scenario);
  return error_of(check_map_size(*scenario, 5, 4));
}

class BadFileTest : public testing::TestWithParam<BadFile> {};

TEST_P(BadFileTest, GetsItsVerdict) {
  const BadFile& bad = GetParam();
  if (bad.verdict == "skip") GTEST_SKIP() << "WEND_DATA names no folder with bad/expected.tsv";
  const std::string error = error_for(bad.file);
  if (bad.verdict == "accept") {
    EXPECT_EQ(error, "no error");
  } else if (bad.verdict == "reject" || error != "no error") {
    EXPECT_NE(error, "no error");
    EXPECT_THAT(error, HasSubstr(fs::path(bad.file).filename().string()));
    EXPECT_LT(error.size(), 300U);
  }
}

INSTANTIATE_TEST_SUITE_P(, BadFileTest, testing::ValuesIn(bad_files()), [](const auto& row) {
  std::string name = row.param.file;
  std::replace_if(
      name.begin(), name.end(),
      [](char letter) { return std::isalnum(static_cast<unsigned char>(letter)) == 0; }, '_');
  return name;
});

/// The content of the files that load.
class OddFile : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(bad_folder())) GTEST_SKIP() << "WEND_DATA names no folder with bad/";
  }

  static std::string cells_in(const std::string& file) {
    const auto loaded = load_map(bad_folder() / file);
    return loaded ? cells_of(loaded->map) : error_of(loaded);
  }

  /// Grey values on the scale 0..255.
  static std::vector<long> values_in(const std::string& file) {
    const auto image = decode_image(bytes_of(bad_folder() / file));
    if (!image) return {};
    std::vector<long> values;
    for (const double value : image->values) {
      values.push_back(std::lround(value * 255 / image->maximum));
    }
    return values;
  }

  const std::vector<long> control_ = {0, 254, 255, 127, 205, 10, 250, 89, 90, 200, 207, 128};
};

TEST_F(OddFile, TheControlMapHasSeventeenFreeCells) {
  const std::string cells = ".....\n.###.\n.....\n.....\n";
  EXPECT_EQ(cells_in("map/ok.map"), cells);
  EXPECT_EQ(cells_in("map/crlf.map"), cells);
  EXPECT_EQ(cells_in("map/lowercase.map"), cells);
  EXPECT_EQ(cells_in("map/all_blocked.map"), "##\n##\n");
}

TEST_F(OddFile, TheseImagesHaveThePixelsOfTheControl) {
  for (const std::string file :
       {"img/p5.pgm", "img/p2_one_per_line.pgm", "img/comment_one_line_header.pgm",
        "img/comment_in_p2_data.pgm", "img/maxval_65535.pgm", "img/gray8.png", "img/gray16.png",
        "img/interlaced.png", "img/two_idat.png", "img/rgba.png", "img/p6_colour.pgm"}) {
    EXPECT_EQ(values_in(file), control_) << file;
  }
}

TEST_F(OddFile, ImagesAreScaledByTheirMaximumAndPalette) {
  const auto image = decode_image(bytes_of(bad_folder() / "img/maxval_100.pgm"));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->maximum, 100);
  EXPECT_EQ(values_in("img/maxval_100.pgm").front(), 0);
  const std::vector<long> palette = values_in("img/palette.png");
  ASSERT_GE(palette.size(), 4U);
  EXPECT_THAT(std::vector<long>(palette.begin(), palette.begin() + 4),
              ElementsAre(0, 254, 205, 255));
}

TEST_F(OddFile, ColoursTakeTheLumaOfNav2) {
  const std::vector<long> values = values_in("img/rgb_colour.png");
  ASSERT_GE(values.size(), 4U);
  EXPECT_THAT(std::vector<long>(values.begin(), values.begin() + 4), ElementsAre(76, 150, 29, 255));
}

TEST_F(OddFile, TheControlYamlIsInRosOrder) {
  const std::string cells = "??.?\n?#.#\n#..?\n";
  for (const std::string file :
       {"ok", "image_parent", "resolution_exponent", "origin_flow_multiline", "mode_trinary",
        "comments_quotes", "crlf", "document_markers", "no_final_newline", "anchor_used"}) {
    EXPECT_EQ(cells_in("yaml/" + file + ".yaml"), cells) << file;
  }
  const Frame frame = load_map(bad_folder() / "yaml/ok.yaml")->map.frame();
  EXPECT_EQ(frame, (Frame{0.05, {-1, -2, 0}, true, true}));
}

TEST_F(OddFile, YamlChangesTheMeaningOfPixels) {
  EXPECT_EQ(cells_in("yaml/negate_1.yaml"), "?##?\n#.#?\n.##?\n");
  EXPECT_EQ(cells_in("yaml/img_rgba.yaml"), "????\n?#?#\n#.??\n");
}

TEST_F(OddFile, RawValuesAreCosts) {
  const auto loaded = load_map(bad_folder() / "yaml/mode_raw.yaml");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(cells_of(loaded->map), ".???\n?.?.\n.???\n");
  EXPECT_THAT(loaded->map.terrain({0, 0}), DoubleEq(1 + 4 * 0.90));
  EXPECT_THAT(loaded->map.terrain({1, 1}), DoubleEq(1 + 4 * 0.10));
  EXPECT_THAT(loaded->map.terrain({3, 1}), DoubleEq(1 + 4 * 0.89));
}

TEST_F(OddFile, ScaledValuesAreTerrain) {
  const TemporaryFolder folder;
  fs::copy(bad_folder() / "yaml/p5.pgm", folder / "p5.pgm");
  const auto loaded = load_map(
      folder.write("scale.yaml", bytes_of(bad_folder() / "yaml/ok.yaml") + "mode: scale\n"));
  ASSERT_TRUE(loaded) << error_of(loaded);
  EXPECT_EQ(cells_of(loaded->map), "....\n.#.#\n#...\n");
  EXPECT_THAT(loaded->map.terrain().values(),
              ElementsAre(DoubleEq(4.96), DoubleEq(1.16), 1, DoubleEq(3.68),  //
                          1, 1, 1, 1,                                         //
                          1, 1, 1, DoubleEq(3.68)));
}

TEST_F(OddFile, ScenariosHaveTheirQueries) {
  for (const std::string file : {"ok", "version_1.0", "crlf", "blank_lines"}) {
    const auto scenario = load_scenario(bad_folder() / "scen" / (file + ".scen"));
    ASSERT_TRUE(scenario) << error_of(scenario);
    ASSERT_EQ(scenario->queries.size(), 2U);
    EXPECT_EQ(scenario->queries[0].goal, (Cell{4, 0}));
    EXPECT_EQ(scenario->queries[0].length, 4);
    EXPECT_EQ(scenario->queries[1].goal, (Cell{4, 3}));
    EXPECT_EQ(scenario->queries[1].length, 6.41421356);
    EXPECT_EQ(scenario->queries[1].decimals, 8);
  }
  EXPECT_THAT(load_scenario(bad_folder() / "scen/version_only.scen")->queries, testing::IsEmpty());
}

TEST_F(OddFile, AMapColumnNeverLeadsOutOfTheFolder) {
  const auto scenario = load_scenario(bad_folder() / "scen/map_path_traversal.scen");
  ASSERT_TRUE(scenario);
  EXPECT_THAT(error_of(scenario_map_path(*scenario)),
              HasSubstr("its map 'passwd' is not in the same folder"));
}

}  // namespace
}  // namespace wend
