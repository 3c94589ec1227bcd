// `wend reference` describes what --help shows: no more, no less, and in the same words.

#include <gmock/gmock.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

json reference() {
  const Outcome outcome = wend({"reference"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return json::parse(outcome.out);
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

/// Text with one space between words, however its lines were broken.
std::string flowing(const std::string& text) {
  std::string line;
  for (const std::string& word : words_of(text)) line += word + ' ';
  return line;
}

std::string help_of(const json& command) {
  std::vector<std::string> arguments = words_of(command["name"]);
  arguments.erase(arguments.begin());  // the program
  arguments.emplace_back("--help-all");
  return wend(arguments).out;
}

/// A command, its subcommands, and theirs.
void collect(const json& command, std::vector<json>& commands) {
  commands.push_back(command);
  for (const json& each : command["subcommands"]) collect(each, commands);
}

std::vector<json> all_commands() {
  std::vector<json> commands;
  collect(reference(), commands);
  return commands;
}

/// The flags that help lists, as it lists them: "-o, --output".
std::vector<std::string> listed_flags(const std::string& help) {
  std::vector<std::string> flags;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  -")) continue;
    std::string names;
    for (const std::string& word : words_of(line)) {
      const std::string name = word.substr(0, word.find_first_of("[,"));
      if (!name.starts_with('-')) break;
      names += (names.empty() ? "" : ", ") + name;
      if (!word.ends_with(',')) break;
    }
    flags.push_back(names);
  }
  return flags;
}

std::string joined(const json& names) {
  std::string text;
  for (const std::string name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

TEST(Reference, HasTheFlagsOfHelpInOrder) {
  for (const json& command : all_commands()) {
    std::vector<std::string> flags;
    for (const json& option : command["options"]) flags.push_back(joined(option["names"]));
    EXPECT_EQ(listed_flags(help_of(command)), flags) << command["name"];
  }
}

TEST(Reference, SaysWhatHelpSays) {
  for (const json& command : all_commands()) {
    const std::string help = flowing(help_of(command));
    std::vector<std::string> texts{command["summary"], command["usage"]};
    for (const auto* list : {"examples", "notes"}) {
      for (const json& text : command[list]) texts.push_back(text);
    }
    for (const auto* list : {"options", "positionals"}) {
      for (const json& argument : command[list]) texts.push_back(argument["help"]);
    }
    for (const json& option : command["options"]) {
      if (option["group"] != "Options") texts.push_back(option["group"]);
    }
    for (const json& each : command["subcommands"]) texts.push_back(each["summary"]);
    for (const std::string& text : texts) {
      EXPECT_THAT(help, HasSubstr(flowing(text).substr(0, flowing(text).size() - 1)));
    }
  }
}

TEST(Reference, HasEverySubcommandThatHelpLists) {
  for (const json& command : all_commands()) {
    const std::string help = help_of(command);
    const std::size_t heading = help.find("\nSubcommands:\n");
    std::vector<std::string> listed;
    std::istringstream lines(heading == std::string::npos ? "" : help.substr(heading + 14));
    for (std::string line; std::getline(lines, line) && !line.empty();) {
      listed.push_back(command["name"].get<std::string>() + ' ' + words_of(line).front());
    }
    std::vector<std::string> names;
    for (const json& each : command["subcommands"]) names.push_back(each["name"]);
    EXPECT_EQ(listed, names);
  }
}

TEST(Reference, TellsHowArgumentsAreGiven) {
  const json plan = reference()["subcommands"][0];
  EXPECT_EQ(plan["name"], "wend plan");
  EXPECT_EQ(plan["usage"], "wend plan [OPTIONS] MAP");
  EXPECT_EQ(plan["positionals"][0]["name"], "MAP");
  EXPECT_EQ(plan["positionals"][0]["required"], true);
  const auto option = [&plan](const std::string& name) {
    for (const json& each : plan["options"]) {
      if (each["names"].back() == name) return each;
    }
    return json();
  };
  EXPECT_EQ(option("--cells")["value"], nullptr);
  EXPECT_EQ(option("--unknown")["value"], "blocked|free");
  EXPECT_EQ(option("--smooth")["value_optional"], true);
  EXPECT_EQ(option("--output")["repeatable"], true);
  EXPECT_EQ(option("--connectivity")["group"], "Planner options");
}

TEST(Reference, KeepsTheLinesThatHelpDoesNotWrap) {
  for (const json& command : all_commands()) {
    if (command["name"] != "wend generate") continue;
    const std::string kinds = command["positionals"][0]["help"];
    EXPECT_THAT(kinds, HasSubstr("parts of the map may be disconnected\nmaze: a perfect maze:"));
  }
}

TEST(Reference, IsHidden) {
  EXPECT_THAT(wend({"--help"}).out, Not(HasSubstr("reference")));
  EXPECT_THAT(wend({"reference"}).out, Not(HasSubstr("wend reference")));
  EXPECT_THAT(wend({"completion", "bash"}).out, Not(HasSubstr("reference")));
  EXPECT_THAT(wend({"referenc"}).err, Not(HasSubstr("reference")));
  EXPECT_THAT(wend({"--no-such-flag"}).err, Not(HasSubstr("reference")));
}

}  // namespace
}  // namespace wend::test
