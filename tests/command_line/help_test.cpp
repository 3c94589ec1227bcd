// What help shows of all there is: --help what most people need, on two screens; --help-all everything; and the flags of
// one planner (or its like) where it is named.

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string line; std::getline(words, line);) lines.push_back(line);
  return lines;
}

/// The words of every command: {"index", "build"}, and of the program: {}.
void collect(const json& command, std::vector<std::string> words,
             std::vector<std::pair<std::vector<std::string>, json>>& commands) {
  commands.emplace_back(words, command);
  for (const json& each : command["subcommands"]) {
    const auto name = each["name"].get<std::string>();
    std::vector<std::string> inner = words;
    inner.push_back(name.substr(name.rfind(' ') + 1));
    collect(each, inner, commands);
  }
}

std::vector<std::pair<std::vector<std::string>, json>> words_of_all_commands() {
  std::vector<std::pair<std::vector<std::string>, json>> commands;
  collect(json::parse(wend({"reference"}).out), {}, commands);
  return commands;
}

std::string help_of(std::vector<std::string> words, const std::string& flag) {
  words.push_back(flag);
  const Outcome outcome = wend(words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

TEST(Help, OfEveryCommandFitsOnTwoScreens) {
  for (const auto& [words, command] : words_of_all_commands()) {
    const auto lines = lines_of(help_of(words, "--help"));
    EXPECT_LE(lines.size(), 50U) << command["name"];
    for (const std::string& line : lines) EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST(Help, NamesWhatMostPeopleNeed) {
  EXPECT_THAT(help_of({"plan"}, "--help"),
              AllOf(HasSubstr("--start X,Y"), HasSubstr("--goal X,Y"), HasSubstr("--planner"),
                    HasSubstr("--robot-radius"), HasSubstr("--smooth"), HasSubstr("-o, --output"),
                    HasSubstr("--step"), Not(HasSubstr("--corner-rule")),
                    Not(HasSubstr("--reverse-factor")), HasSubstr("\n  wend plan office.yaml")));
}

/// What is left out of --help is counted there, and in --help-all.
TEST(Help, SaysHowMuchMoreThereIs) {
  for (const auto& [words, command] : words_of_all_commands()) {
    const std::string help = help_of(words, "--help");
    std::size_t others = 0;
    bool all_there = true;
    for (const json& option : command["options"]) {
      const auto name = option["names"].back().get<std::string>();
      all_there = all_there && help.find("\n  " + name) != std::string::npos;
      if (option["group"] != "Options") ++others;
    }
    if (help.find("--help-all`") == std::string::npos) continue;  // it is all there
    if (others > 0) {
      EXPECT_THAT(help, HasSubstr("and " + std::to_string(others) + " more options"));
    }
  }
}

TEST(Help, AllHasEveryOptionInFull) {
  for (const auto& [words, command] : words_of_all_commands()) {
    const std::string help = help_of(words, "--help-all");
    for (const json& option : command["options"]) {
      EXPECT_THAT(help, HasSubstr(option["names"].back().get<std::string>()));
    }
    if (words.empty()) continue;
    for (const std::string& line : lines_of(help)) EXPECT_LE(line.size(), 80U) << line;
  }
}

/// Every option of every planner, and no other flag, with its own default.
TEST(Help, OfAPlannerHasItsOptionsAlone) {
  const json listing = json::parse(wend({"planners", "--format", "json"}).out);
  for (const json& planner : listing["planners"]) {
    const auto name = planner["name"].get<std::string>();
    const Outcome outcome = wend({"plan", "--planner", name, "--help"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::vector<std::string> shown;
    for (const std::string& line : lines_of(outcome.out)) {
      if (!line.starts_with("  --")) continue;
      std::string flag = line.substr(4, line.find_first_of(" ,", 4) - 4);
      std::replace(flag.begin(), flag.end(), '-', '_');
      shown.push_back(flag);
    }
    std::vector<std::string> options;
    for (const json& option : planner["options"]) options.push_back(option["name"]);
    EXPECT_THAT(shown, testing::UnorderedElementsAreArray(options)) << name;
  }
}

TEST(Help, OfAChoiceIsGivenWhereverThereIsOne) {
  const std::vector<std::vector<std::string>> commands{
      {"plan", "map.yaml", "--planner", "astar:weight=2", "--help"},
      {"follow", "--planner", "astar", "--help"}};
  for (const auto& command : commands) {
    EXPECT_THAT(wend(command).out,
                AllOf(StartsWith("Options of the planner astar:\n"), HasSubstr("--weight NUMBER"),
                      Not(HasSubstr("--reverse-factor")), HasSubstr("--help`")));
  }
  EXPECT_THAT(wend({"follow", "--controller", "pid", "--help"}).out,
              HasSubstr("Options of the controller pid:\n"));
  EXPECT_THAT(wend({"smooth", "--smoother", "gradient", "--help"}).out,
              HasSubstr("Options of the smoother gradient:\n"));
  EXPECT_THAT(wend({"generate", "office", "--help"}).out,
              AllOf(HasSubstr("--furniture"), Not(HasSubstr("--density"))));
}

TEST(Help, OfAPlannerThatDoesNotExistIsAnError) {
  const Outcome outcome = wend({"plan", "--planner", "astr", "--help"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, HasSubstr("there is no planner 'astr': did you mean 'astar'?"));
}

TEST(Planners, AreATableOfALineEach) {
  const auto lines = lines_of(wend({"planners"}).out);
  const json listing = json::parse(wend({"planners", "--format", "json"}).out);
  ASSERT_EQ(lines.size(), listing["planners"].size() + 2);
  for (const std::string& line : lines) EXPECT_LE(line.size(), 80U) << line;
  std::size_t line = 1;
  for (const json& planner : listing["planners"]) {
    EXPECT_THAT(lines[line], AllOf(StartsWith(planner["name"].get<std::string>() + " "),
                                   HasSubstr(planner["promise"].get<std::string>()),
                                   HasSubstr(planner["summary"].get<std::string>())));
    ++line;
  }
}

TEST(Planners, TellAllAboutThoseThatAreNamed) {
  const Outcome one = wend({"planners", "jps"});
  EXPECT_EQ(one.code, 0) << one.err;
  EXPECT_THAT(one.out, AllOf(StartsWith("jps\n"), HasSubstr("  guarantee "), HasSubstr("  paper "),
                             Not(HasSubstr("astar\n"))));
  EXPECT_EQ(wend({"planners", "bfs", "jps"}).out, wend({"planners", "bfs"}).out + "\n" + one.out);
  const json some = json::parse(wend({"planners", "bfs", "jps", "--format", "json"}).out);
  EXPECT_EQ(some["planners"].size(), 2U);
  const Outcome wrong = wend({"planners", "astr"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean 'astar'?"));
}

}  // namespace
}  // namespace wend::test
