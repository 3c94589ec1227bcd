#include "wend/io/query/dynamic_scenario.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using testing::HasSubstr;

constexpr const char* kPatches =
    "type patch\npatches 2\npatch 0\nheight 2\nwidth 3\nmap\n@.@\n...\n"
    "patch 1\nheight 1\nwidth 1\nmap\nG\n";

Expected<DynamicScenario, Error> parsed(const std::string& commands,
                                        const std::string& patches = kPatches) {
  const std::string text =
      "version 2\nheight 4\nwidth 5\ncost 1 octile\npatch p.patch\ncommands\n" + commands;
  return parse_dynamic_scenario(text, "s.scen", [&](const std::filesystem::path& file) {
    EXPECT_EQ(file, "p.patch");
    return Expected<std::string, Error>(patches);
  });
}

TEST(DynamicScenario, ReadsQueriesAndPatches) {
  const auto scenario = parsed("Q 0 0 0 4 3 5.2426\nP 1 0 2 1\nQ 1 1 1 1 1 0\n");
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->width, 5);
  EXPECT_EQ(scenario->height, 4);
  ASSERT_EQ(scenario->commands.size(), 3U);
  const auto& query = std::get<ScenarioQuery>(scenario->commands[0]);
  EXPECT_EQ(query.goal, (Cell{4, 3}));
  EXPECT_EQ(query.length, 5.2426);
  EXPECT_EQ(query.decimals, 4);
  EXPECT_EQ(query.line, 7U);
  const MapEdit edit = scenario->edit_of(std::get<PatchCommand>(scenario->commands[1]));
  EXPECT_EQ(edit.corner, (Cell{2, 1}));
  EXPECT_EQ((edit.states[{0, 0}]), CellState::occupied);
  EXPECT_EQ((edit.states[{1, 0}]), CellState::free);
  EXPECT_EQ((edit.states[{0, 1}]), CellState::free);
}

TEST(DynamicScenario, SaysWhatIsWrongAndWhere) {
  const auto wrong = [](const std::string& commands, const std::string& patches = kPatches) {
    return error_of(parsed(commands, patches));
  };
  EXPECT_THAT(wrong("X 1\n"), HasSubstr("s.scen:7: expected 'Q bucket"));
  EXPECT_THAT(wrong("Q 0 0 0 5 3 5\n"), HasSubstr("x '5' is not a whole number from 0 to 4"));
  EXPECT_THAT(wrong("Q 0 0 0 4 3 -1\n"), HasSubstr("the length must be finite and at least 0"));
  EXPECT_THAT(wrong("P 0 2 0 0\n"), HasSubstr("patch '2' is not a whole number from 0 to 1"));
  EXPECT_THAT(wrong("P 0 0 3 0\n"),
              HasSubstr("patch 0 of 3 x 2 cells at (3,0) reaches over the map of 5 x 4"));
  EXPECT_THAT(wrong("", "type octile\n"), HasSubstr("p.patch:1: expected 'type patch'"));
  EXPECT_THAT(wrong("", "type patch\npatches 1\npatch 0\nheight 2\nwidth 2\nmap\n..\n"),
              HasSubstr("the file ends in the middle of a patch"));
  EXPECT_THAT(wrong("", "type patch\npatches 1\npatch 0\nheight 1\nwidth 2\nmap\n...\n"),
              HasSubstr("the row has 3 letters, the patch is 2 wide"));
  EXPECT_THAT(error_of(parse_dynamic_scenario(
                  "version 2\nheight 4\nwidth 5\ncost 1 octile\n"
                  "patch ../p.patch\ncommands\n",
                  "s", [](const auto&) { return Expected<std::string, Error>(""); })),
              HasSubstr("must lie in the same folder"));
}

}  // namespace
}  // namespace wend
