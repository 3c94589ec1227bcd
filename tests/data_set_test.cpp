// Real maps: every MovingAI scenario under WEND_DATA, every length right and every path checked
// cell by cell. Sample/... takes some queries of each file, All/... takes all of them (ctest label
// "long").

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/testing/build_paths.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/query/scenario.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kFolders{"movingai", "grids", "nine"};

bool is_wanted(const fs::path& file) {
  if (file.extension() != ".scen") return false;
  // The lengths of these sets' own scenarios are of older maps; they lie there recomputed.
  const bool recomputed = file.stem().extension() == ".recomputed";
  return recomputed || file.parent_path().filename() != "wc3maps512";
}

std::vector<std::string> scenario_files() {
  std::vector<std::string> files;
  if (data_folder().empty()) return files;
  for (const std::string_view folder : kFolders) {
    const fs::path root = data_folder() / folder;
    if (!fs::exists(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (is_wanted(entry.path())) {
        files.push_back(fs::relative(entry.path(), data_folder()).generic_string());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& test) {
  std::string name = test.param;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

/// The number of the first cell that is blocked or that no legal step leads to; -1 if all are well.
/// A diagonal step needs both cells beside it free.
std::ptrdiff_t first_fault(const GridMap& map, std::span<const Cell> cells) {
  const auto is_free = [&](Cell cell) {
    return map.contains(cell) && map.state(cell) == CellState::free;
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell to = cells[i];
    const Cell from = cells[i == 0 ? 0 : i - 1];
    const int dx = std::abs(to.x - from.x);
    const int dy = std::abs(to.y - from.y);
    const bool steps = i == 0 || std::max(dx, dy) == 1;
    const bool clear = is_free({from.x, to.y}) && is_free({to.x, from.y});
    if (!is_free(to) || !steps || !clear) return static_cast<std::ptrdiff_t>(i);
  }
  return -1;
}

double length_of(std::span<const Cell> cells) {
  double length = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    length += std::hypot(cells[i].x - cells[i - 1].x, cells[i].y - cells[i - 1].y);
  }
  return length;
}

/// How far a length may be from what the file prints.
double tolerance(const ScenarioQuery& query) {
  const double relative = 1e-5 * query.length;
  const bool fixed_decimals = query.decimals == 2 || query.decimals == 8;
  // A hair more than half a unit, as the printed number is itself rounded to binary.
  return fixed_decimals ? std::max(relative, 0.50001 * std::pow(10, -query.decimals)) : relative;
}

/// Rows of files for fleets all say 0: of those only the path is checked, not its length.
void check(Planner& planner, const GridMap& map, const ScenarioQuery& query, bool has_lengths,
           Plan& plan) {
  SCOPED_TRACE("line " + std::to_string(query.line));
  const Status status = planner.plan(Query::between(query.start, query.goal), plan);
  if (has_lengths && query.says_no_path()) {
    EXPECT_NE(to_string(status), to_string(Status::found));
    return;
  }
  ASSERT_EQ(to_string(status), to_string(Status::found));
  const auto cells = plan.path.cells();
  ASSERT_FALSE(cells.empty());
  EXPECT_EQ(cells.front(), query.start);
  EXPECT_EQ(cells.back(), query.goal);
  EXPECT_EQ(first_fault(map, cells), -1);
  EXPECT_NEAR(plan.cost, length_of(cells), 1e-9 * std::max(1.0, plan.cost));
  if (!has_lengths) return;
  EXPECT_NEAR(length_of(cells), query.length, tolerance(query));
  EXPECT_TRUE(length_matches(query, plan.cost));
}

/// Plans at most `most` queries of a file, evenly spread.
void check_file(const std::string& file, std::size_t most) {
  const auto scenario = load_scenario(data_folder() / file);
  ASSERT_TRUE(scenario) << scenario.error().message;
  ASSERT_FALSE(scenario->queries.empty());
  const auto map_file = scenario_map_path(*scenario);
  ASSERT_TRUE(map_file) << map_file.error().message;
  const auto loaded = load_map(*map_file);
  ASSERT_TRUE(loaded) << loaded.error().message;
  const auto sized = check_map_size(*scenario, loaded->map.width(), loaded->map.height());
  ASSERT_TRUE(sized) << sized.error().message;
  const auto planner = make_planner("astar", *make_free_space(loaded->map));
  ASSERT_TRUE(planner) << planner.error().message;
  Plan plan;
  const bool has_lengths =
      std::ranges::any_of(scenario->queries, [](const auto& query) { return query.length > 0; });
  const std::size_t count = scenario->queries.size();
  const std::size_t checked = std::min(most, count);
  for (std::size_t i = 0; i < checked && !::testing::Test::HasFailure(); ++i) {
    const std::size_t chosen = checked == 1 ? 0 : i * (count - 1) / (checked - 1);
    check(**planner, loaded->map, scenario->queries[chosen], has_lengths, plan);
  }
}

TEST(DataSets, AreThere) {
  if (data_folder().empty()) {
    GTEST_SKIP() << "no data: configure with -DWEND_DATA=FOLDER to test on real maps";
  }
  EXPECT_FALSE(scenario_files().empty()) << "no scenarios in " << data_folder();
}

class SampleOfScenario : public ::testing::TestWithParam<std::string> {};
class WholeScenario : public ::testing::TestWithParam<std::string> {};

TEST_P(SampleOfScenario, HasNothingWrong) { check_file(GetParam(), 25); }
TEST_P(WholeScenario, HasNothingWrong) { check_file(GetParam(), SIZE_MAX); }

// Without data there is nothing to instantiate.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SampleOfScenario);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(WholeScenario);
INSTANTIATE_TEST_SUITE_P(Sample, SampleOfScenario, ::testing::ValuesIn(scenario_files()),
                         test_name);
INSTANTIATE_TEST_SUITE_P(All, WholeScenario, ::testing::ValuesIn(scenario_files()), test_name);

}  // namespace
}  // namespace wend::test
