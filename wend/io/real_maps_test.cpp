// Real maps and scenarios of the shared data load, with the sizes and free cells that its README gives.

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

#include "tests/testing/build_paths.hpp"
#include "wend/base/parse.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/map_yaml.hpp"
#include "wend/io/query/scenario.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

/// What the README's tables say about a file; missing values are empty.
struct Described {
  std::string size;  // "49x49"
  std::string free;  // percent, like the fields below
  std::string occupied;
  std::string unknown;
};

/// The cells of a Markdown table's row; empty if the line is not a row.
std::vector<std::string> columns_of(const std::string& line) {
  std::vector<std::string> columns;
  std::istringstream stream(line);
  for (std::string column; std::getline(stream, column, '|');) {
    columns.emplace_back(trimmed(column));
  }
  return columns;
}

/// "4.1" in "png ct2; occupied 4.1% unknown 58.4%" after "occupied "; empty if it is not there.
std::string percent_after(const std::string& word, const std::string& text) {
  const std::size_t at = text.find(word);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + word.size();
  return text.substr(begin, text.find('%', begin) - begin);
}

std::map<std::string, Described> descriptions() {
  std::map<std::string, Described> files;
  std::istringstream readme(bytes_of(test::data_folder() / "README.md"));
  for (std::string line; std::getline(readme, line);) {
    const auto columns = columns_of(line);
    if (columns.size() < 7) continue;
    files[columns[1]] = {columns[4], columns[5], percent_after("occupied ", columns[6]),
                         percent_after("unknown ", columns[6])};
  }
  return files;
}

std::vector<fs::path> files_in(const std::set<std::string>& folders, const std::string& extension) {
  std::vector<fs::path> files;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(test::data_folder() / folder)) {
      if (entry.path().extension() == extension) files.push_back(entry.path());
    }
  }
  return files;
}

std::string name_of(const fs::path& file) {
  return file.lexically_relative(test::data_folder()).generic_string();
}

void expect_percent(std::size_t part, const GridMap& map, const std::string& percent) {
  if (percent.empty()) return;
  EXPECT_NEAR(100.0 * static_cast<double>(part) / static_cast<double>(map.size()),
              parse_number(percent).value(), 0.0501);
}

void expect_size(const GridMap& map, const Described& described) {
  EXPECT_EQ(std::to_string(map.width()) + "x" + std::to_string(map.height()), described.size);
}

class RealMaps : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(test::data_folder() / "movingai")) GTEST_SKIP() << "WEND_DATA names no data";
  }
};

TEST_F(RealMaps, MovingAiMapsAreAsTheReadmeSays) {
  const auto described = descriptions();
  const auto files = files_in({"movingai", "grids", "nine"}, ".map");
  EXPECT_GT(files.size(), 70U);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file);
    const auto loaded = load_map(file);
    ASSERT_TRUE(loaded) << error_of(loaded);
    const auto found = described.find(name_of(file));
    if (found == described.end()) continue;
    expect_size(loaded->map, found->second);
    if (!loaded->notes.empty()) continue;  // the README counts E and lower case as blocked
    expect_percent(loaded->map.size() - loaded->map.occupied().count(), loaded->map,
                   found->second.free);
  }
}

TEST_F(RealMaps, RosMapsAreAsTheReadmeSays) {
  const std::set<std::string> without_image = {"ros/f1tenth/porto.yaml",
                                               "ros/nav2_testmap/invalid_image.yaml"};
  const auto described = descriptions();
  for (const fs::path& file : files_in({"ros", "tracks"}, ".yaml")) {
    SCOPED_TRACE(file);
    const auto loaded = load_map(file);
    ASSERT_EQ(!loaded, without_image.contains(name_of(file))) << error_of(loaded);
    if (!loaded) continue;
    const auto yaml = parse_map_yaml(bytes_of(file), file.string());
    const auto found =
        described.find(name_of((file.parent_path() / yaml->image).lexically_normal()));
    ASSERT_NE(found, described.end());
    const GridMap& map = loaded->map;
    expect_size(map, found->second);
    expect_percent(map.occupied().count(), map, found->second.occupied);
    expect_percent(map.unknown().count(), map, found->second.unknown);
    if (yaml->meaning.mode != ImageMode::trinary) continue;
    expect_percent(map.size() - map.occupied().count() - map.unknown().count(), map,
                   found->second.free);
  }
}

TEST_F(RealMaps, BareImagesLoad) {
  for (const std::string extension : {".png", ".pgm"}) {
    for (const fs::path& file : files_in({"ros", "tracks"}, extension)) {
      const auto loaded = load_map(file);
      EXPECT_TRUE(loaded) << error_of(loaded);
    }
  }
}

TEST_F(RealMaps, ScenariosBelongToTheMapBesideThem) {
  const auto files = files_in({"movingai", "grids", "nine"}, ".scen");
  EXPECT_GT(files.size(), 70U);
  for (const fs::path& file : files) {
    const auto scenario = load_scenario(file);
    ASSERT_TRUE(scenario) << error_of(scenario);
    EXPECT_FALSE(scenario->queries.empty()) << file;
    const auto map_file = scenario_map_path(*scenario);
    ASSERT_TRUE(map_file) << error_of(map_file);
    const auto loaded = load_map(*map_file);
    ASSERT_TRUE(loaded) << error_of(loaded);
    const auto fits = check_map_size(*scenario, loaded->map.width(), loaded->map.height());
    EXPECT_TRUE(fits) << error_of(fits);
  }
}

}  // namespace
}  // namespace wend
