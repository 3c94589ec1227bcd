// What wend writes of a plan, wend reads: the program's JSON and CSV files.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"
#include "wend/io/path/load_path.hpp"

namespace wend::test {
namespace {

TEST(PlanFile, GivesThePathBack) {
  const TemporaryFolder folder;
  const std::string map = folder.write("grid.txt", "....\n.##.\n....\n");
  const std::string csv = folder / "plan.csv";
  const std::string json = folder / "plan.json";
  const Outcome outcome = wend(
      {"plan", map, "--start", "0,0", "--goal", "3,2", "--format", "json", "-o", csv, "-o", json});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::vector<Cell> cells;
  const auto plan = nlohmann::json::parse(outcome.out);
  for (const auto& cell : plan.at("path")) cells.push_back({cell.at(0), cell.at(1)});
  ASSERT_GE(cells.size(), 4U);
  for (const std::string& file : {csv, json, folder.write("printed", outcome.out)}) {
    const auto path = load_path(file, {});
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(*path, Path(cells)) << file;
  }
}

TEST(PlanFile, OfAPlanThatFailedIsAnError) {
  const TemporaryFolder folder;
  const std::string map = folder.write("grid.txt", ".#.\n");
  const Outcome outcome =
      wend({"plan", map, "--start", "0,0", "--goal", "2,0", "--format", "json"});
  ASSERT_EQ(outcome.code, 1);
  const auto path = load_path(folder.write("plan.json", outcome.out), {});
  ASSERT_FALSE(path);
  EXPECT_THAT(path.error().message,
              testing::HasSubstr("no path: there is no path from start (0,0) to goal (2,0)"));
}

}  // namespace
}  // namespace wend::test
