// The program wend from outside: usage, and every subcommand but plan, field, bench and convert.

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/command_line/run_program.hpp"
#include "tests/testing/build_paths.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

const std::vector<std::string> kSubcommands{"plan",     "field",    "bench",   "info",
                                            "planners", "generate", "convert", "completion"};

TEST(Usage, HelpIsAResult) {
  const Outcome help = wend({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.err, IsEmpty());
  for (const std::string& name : kSubcommands) EXPECT_THAT(help.out, HasSubstr("  " + name));
}

TEST(Usage, EverySubcommandHasHelpWithExamples) {
  for (const std::string& name : kSubcommands) {
    const Outcome help = wend({name, "--help"});
    EXPECT_EQ(help.code, 0) << name;
    EXPECT_THAT(help.out, AllOf(HasSubstr("Examples:\n  wend "), HasSubstr("\n  wend " + name),
                                HasSubstr("Usage:")));
  }
}

TEST(Usage, HelpFitsAnOrdinaryTerminal) {
  constexpr std::size_t kColumns = 80;
  for (const std::string name :
       {"", "plan", "field", "info", "generate", "convert", "compare", "explain", "view"}) {
    const std::string help = wend({name.empty() ? "--help" : name, "--help"}).out;
    std::istringstream flags(help.substr(0, help.find("Examples:")));
    for (std::string line; std::getline(flags, line);) EXPECT_LE(line.size(), kColumns) << line;
  }
}

TEST(Usage, VersionIsAResult) {
  const Outcome version = wend({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_THAT(version.out, testing::MatchesRegex("wend [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Usage, VersionIsTheSameWhereverItIsWritten) {
  std::string version = wend({"--version"}).out.substr(std::string("wend ").size());
  version.pop_back();  // the line's end
  const std::string source = source_folder();
  EXPECT_THAT(bytes_of(source + "/CITATION.cff"), HasSubstr("\nversion: " + version + "\n"));
  EXPECT_THAT(bytes_of(source + "/CHANGELOG.md"), StartsWith("# Changelog\n\n## " + version));
  EXPECT_THAT(bytes_of(source + "/ros/wend_ros/package.xml"),
              HasSubstr("<version>" + version + "</version>"));
}

TEST(Usage, BadUsageSaysWhatToDo) {
  struct Case {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::vector<Case> cases{
      {{}, "choose a subcommand: plan,"},
      {{"plann"}, "unknown subcommand 'plann': did you mean plan?"},
      {{"walk"}, "unknown subcommand 'walk': choose plan,"},
      {{"--verison"}, "unknown option --verison: did you mean --version?"},
      {{"info"}, "MAP is required"},
      {{"info", "a.map", "b.map"}, "unexpected argument 'b.map'"},
      {{"info", "a.map", "--format", "xml"}, "--format: 'xml' is not one of text, json"},
      {{"plan", "a.map", "--strat", "1,1", "--goal", "2,2"},
       "unknown option --strat: did you mean --start?"},
      {{"plan", "a.map", "--start=1,1", "--gaol=2,2"}, "unknown option --gaol"},
      {{"plan", "a.map", "--start", "1,1"}, "--goal is required"},
      {{"plan", "a.map", "--start"}, "--start"},
  };
  for (const Case& wrong : cases) {
    const Outcome outcome = wend(wrong.arguments);
    EXPECT_EQ(outcome.code, 2) << wrong.message;
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, AllOf(StartsWith("wend: "), HasSubstr(wrong.message)));
  }
}

TEST(Output, AReaderWhoGoesAwayIsNoError) {
  const TemporaryFolder folder;
  const std::string line = "$WEND generate random --size 2000x2000 | head -n 1 | wc -c";
  const Outcome outcome = shell(line);
  EXPECT_EQ(outcome.out, "2001\n");
  EXPECT_THAT(outcome.err, IsEmpty());
  const Outcome code =
      shell("( $WEND generate random --size 2000x2000; echo $? >&2 ) | head -n 1 >/dev/null");
  EXPECT_EQ(code.err, "0\n");
}

TEST(Output, ResultsThatAreLostAreAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const Outcome outcome = shell("$WEND planners >/dev/full");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("cannot write the results"));
}

TEST(Planners, AreDescribedForPeople) {
  std::vector<std::string> words = planners().names();
  words.insert(words.begin(), "planners");
  const Outcome listing = wend(words);
  EXPECT_EQ(listing.code, 0);
  for (const std::string name : {"astar", "dijkstra", "greedy", "bfs", "dfs", "random_walk"}) {
    EXPECT_THAT(listing.out, HasSubstr(name + "\n"));
  }
  EXPECT_THAT(listing.out, AllOf(HasSubstr("Hart, Nilsson, Raphael 1968"),
                                 HasSubstr("weight (or lambda, w) = 1: 0 to 1e+06"),
                                 HasSubstr("\n  memory         16 bytes per cell, 4"),
                                 HasSubstr("\n  when           The default")));
  std::istringstream lines(listing.out);
  for (std::string line; std::getline(lines, line);) {
    const bool of_option = line.starts_with("    ") && !line.starts_with(std::string(17, ' '));
    EXPECT_TRUE(of_option || line.size() <= 90) << line;
  }
}

TEST(Planners, AreListedForPrograms) {
  const json listing = json::parse(wend({"planners", "--format", "json"}).out).at("planners");
  ASSERT_EQ(listing.size(), planners().size());
  for (const json& planner : listing) {
    for (const char* key : {"name", "summary", "idea", "guarantee", "promise", "time", "memory",
                            "when", "preprocessing", "citation"}) {
      EXPECT_FALSE(planner.at(key).get<std::string>().empty()) << planner.at("name") << key;
    }
    for (const json& option : planner.at("options")) {
      EXPECT_TRUE(option.contains("choices") || option.at("kind") == "flag" ||
                  option.at("least") <= option.at("greatest"));
      EXPECT_FALSE(option.at("help").get<std::string>().empty());
    }
  }
}

TEST(Info, SaysWhatATextGridHolds) {
  const TemporaryFolder folder;
  const std::string map = folder.write("grid.txt", "..#3\n??#.\n");
  const Outcome info = wend({"info", map});
  EXPECT_EQ(info.code, 0);
  EXPECT_THAT(info.out,
              AllOf(HasSubstr("text grid"), HasSubstr("4 x 2 cells"), HasSubstr("4 cells (50.0 %)"),
                    HasSubstr("1 to 3 times"), HasSubstr("2; the largest has 2 cells, 50.0 %")));
}

TEST(Info, CountsInGoodEnglish) {
  const TemporaryFolder folder;
  const auto told = [&](const std::string& rows) {
    return wend({"info", folder.write("grid.txt", rows)}).out;
  };
  EXPECT_THAT(told(".#\n##\n"), AllOf(HasSubstr("free        1 cell (25.0 %)\n"),
                                      HasSubstr("components  1, of one cell\n")));
  EXPECT_THAT(told("."), HasSubstr("size        1 x 1 cell\n"));
  EXPECT_THAT(told("..\n"), AllOf(HasSubstr("free        2 cells (100 %)\n"),
                                  HasSubstr("occupied    0 cells (0 %)\n")));
  EXPECT_THAT(told(".#.\n"), HasSubstr("2; the largest has 1 cell, 50.0 % of the free ones\n"));
  // One cell of many is not nothing, nor are all but one all.
  const std::string row(2000, '.');
  EXPECT_THAT(told(row + "\n" + row.substr(2) + "#.\n"),
              AllOf(HasSubstr("occupied    1 cell (0.1 %)\n"), HasSubstr("(99.9 %)")));
}

TEST(Generate, KeepsTheCellsThatAreAskedFor) {
  const auto made = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"generate", "random", "--size", "20x20"});
    return wend(std::move(more));
  };
  const Outcome full = made({"--density", "1", "--keep", "0,0,19,19", "--keep", "3,2"});
  EXPECT_EQ(full.code, 0) << full.err;
  std::istringstream rows(full.out);
  std::vector<std::string> lines;
  for (std::string line; std::getline(rows, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 20U);
  EXPECT_EQ(lines[0][0], '.');
  EXPECT_EQ(lines[19][19], '.');
  EXPECT_EQ(lines[2][3], '.');
  const auto before = std::ranges::count(made({"--density", "1"}).out, '.');
  const auto free = std::ranges::count(full.out, '.');
  EXPECT_GE(free, 39) << "a way along edges from corner to corner";
  EXPECT_LE(free, 39 + 5) << "and to it from the third";
  EXPECT_THAT(full.err, HasSubstr(": " + std::to_string(free - before - 3) +
                                  " more cells were freed, so that a path joins the kept ones"));
  const Outcome open = made({"--density", "0", "--keep", "0,0,19,19"});
  EXPECT_EQ(open.code, 0);
  EXPECT_THAT(open.err, IsEmpty());
  for (const std::string wrong : {"20,0", "-1,0", "1", "1,2,3", "a,b", "1,2,", ""}) {
    const Outcome refused = made({"--keep=" + wrong});
    EXPECT_EQ(refused.code, 2) << wrong;
    EXPECT_THAT(refused.err, HasSubstr("--keep")) << wrong;
    EXPECT_THAT(refused.out, IsEmpty());
  }
}

TEST(Info, HasTheSameForPrograms) {
  const TemporaryFolder folder;
  const std::string map = folder.write("grid.txt", "..#3\n??#.\n");
  const json info = json::parse(wend({"info", map, "--format", "json"}).out);
  EXPECT_EQ(info.at("width"), 4);
  EXPECT_EQ(info.at("height"), 2);
  EXPECT_EQ(info.at("free"), 4);
  EXPECT_EQ(info.at("occupied"), 2);
  EXPECT_EQ(info.at("unknown"), 2);
  EXPECT_EQ(info.at("terrain"),
            json({{"least", 1.0}, {"mean", 1.5}, {"greatest", 3.0}, {"step", 1.0 / 256}}));
  EXPECT_EQ(info.at("components"), json({{"count", 2}, {"largest", 2}}));
  EXPECT_EQ(info.at("frame").at("metric"), false);
}

TEST(Info, TakesTheRobotIntoAccount) {
  const TemporaryFolder folder;
  const std::string map = folder.write("grid.txt", "...#\n....\n");
  const std::vector<std::string> arguments{"info", map, "--robot-radius", "1", "--format", "json"};
  EXPECT_EQ(json::parse(wend(arguments).out).at("passable"), 4);
}

TEST(Info, SaysWhereTheRobotKeepsAwayBesideWhatTheFileSays) {
  const TemporaryFolder folder;
  const std::string map = folder.write("grid.txt", "#....\n");
  const std::vector<std::string> arguments{"info", map, "--clearance-distance", "2"};
  EXPECT_THAT(wend(arguments).out,
              AllOf(HasSubstr("costs the same everywhere"),
                    HasSubstr("2 cells (50.0 %) cost more: an obstacle is "
                              "within 2 cells of the robot; planners round to 1/256")));
  const json info =
      json::parse(wend({"info", map, "--clearance-distance", "2", "--format", "json"}).out);
  EXPECT_EQ(info.at("keep_away"), json({{"distance", 2.0}, {"cells", 2}}));
  EXPECT_EQ(info.at("terrain").at("greatest"), 1.0);
}

TEST(Info, CountsInMetresWhereAnImageIsGivenAResolution) {
  const TemporaryFolder folder;
  const std::string map = folder.write("map.pgm", "P2\n2 1\n255\n255 0\n");
  const Outcome info = wend({"info", map, "--resolution", "0.5"});
  EXPECT_THAT(info.out, AllOf(HasSubstr("2 x 1 cells, 1 x 0.5 m"), HasSubstr("0.5 m a cell")));
  const std::string grid = folder.write("grid.txt", "..\n");
  const Outcome refused = wend({"info", grid, "--resolution", "0.5"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--resolution is for bare images"));
  EXPECT_EQ(wend({"info", map, "--resolution", "0"}).code, 2);
}

TEST(Info, SaysWhyAMapDoesNotLoad) {
  const Outcome missing = wend({"info", "no/such.map"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.out, IsEmpty());
  EXPECT_THAT(missing.err, StartsWith("wend: no/such.map: "));
}

TEST(Generate, PrintsATextGridOrSavesAMap) {
  const TemporaryFolder folder;
  const Outcome printed = wend({"generate", "maze", "--size", "21x11", "--seed", "3"});
  EXPECT_EQ(printed.code, 0);
  EXPECT_EQ(printed.out.size(), 22U * 11U);
  const std::string file = folder / "maze.map";
  const Outcome saved = wend({"generate", "maze", "--size", "21x11", "--seed", "3", "-o", file});
  EXPECT_EQ(saved.code, 0);
  EXPECT_THAT(saved.out, HasSubstr("maze: 21 x 11 cells, seed 3"));
  EXPECT_EQ(json::parse(wend({"info", file, "--format", "json"}).out).at("width"), 21);
}

TEST(Generate, KeepsAPictureThatBelongsToSomethingElse) {
  const TemporaryFolder folder;
  const std::string picture = folder.write("floor.png", "a photograph");
  const std::string map = folder / "floor.yaml";
  const std::vector<std::string> command{"generate", "maze", "--size", "21x11", "-o", map};
  const Outcome refused = wend(command);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("this would replace " + picture), HasSubstr("--force")));
  EXPECT_EQ(bytes_of(picture), "a photograph");
  EXPECT_FALSE(std::filesystem::exists(map));
  std::vector<std::string> forced = command;
  forced.insert(forced.end(), {"--force", "--format", "json"});
  EXPECT_EQ(json::parse(wend(forced).out).at("files"), json({picture, map}));
  const Outcome again = wend(command);
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("\nwritten: " + picture + ", " + map + "\n"));
}

TEST(Generate, MakesEveryKindFromASeed) {
  for (const std::string kind :
       {"random", "maze", "rooms", "office", "warehouse", "rough", "car", "parking", "car_park"}) {
    const TemporaryFolder folder;
    const std::string map = folder / "map.txt";
    const Outcome outcome = wend({"generate", kind, "--size", "220x160", "--seed", "5", "-o", map});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const json info = json::parse(wend({"info", map, "--format", "json"}).out);
    EXPECT_EQ(info.at("width"), 220) << kind;
    EXPECT_GT(info.at("free"), 0) << kind;
  }
}

TEST(Generate, KeepsRoughRoadInEveryFormatThatHasTerrain) {
  const TemporaryFolder folder;
  for (const std::string kind : {"car", "parking"}) {
    const std::vector<std::string> command{"generate", kind, "--size", "40x30", "--seed", "5"};
    const std::string printed = folder.write(kind + ".txt", wend(command).out);
    std::vector<std::string> saving = command;
    saving.insert(saving.end(), {"-o", folder / (kind + ".yaml")});
    EXPECT_EQ(wend(saving).code, 0);
    const json text = json::parse(wend({"info", printed, "--format", "json"}).out);
    const json ros = json::parse(wend({"info", folder / (kind + ".yaml"), "--format", "json"}).out);
    EXPECT_EQ(text.at("terrain").at("greatest"), 2);
    for (const std::string key : {"width", "height", "free", "occupied", "terrain"}) {
      EXPECT_EQ(text.at(key), ros.at(key)) << kind << ' ' << key;
    }
  }
}

TEST(Generate, HasItsGeneratorsOptionsAsFlags) {
  const json full = json::parse(
      wend({"generate", "random", "--size", "9x9", "--density=1", "--format", "json"}).out);
  EXPECT_LT(full.at("free_share"), 0.1);
  EXPECT_EQ(wend({"generate", "office", "--size", "120x100", "--no-furniture"}).code, 0);
  const Outcome other = wend({"generate", "maze", "--size", "9x9", "--density", "1"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("the generator 'maze' has no option --density; random has it"));
}

TEST(Generate, RefusesWhatItCannotMake) {
  for (const std::string size :
       {"0x5", "-3x5", "5", "5x", "axb", "5x5x5", "1e3x5", "99999x99999"}) {
    EXPECT_EQ(wend({"generate", "random", "--size", size}).code, 2) << size;
  }
  EXPECT_EQ(wend({"generate", "random", "--size", "5x5", "--seed", "-1"}).code, 2);
  EXPECT_EQ(wend({"generate", "random", "--size", "5x5", "-o", "map.bmp"}).code, 2);
  EXPECT_THAT(wend({"generate", "maz", "--size", "5x5"}).err, HasSubstr("did you mean 'maze'?"));
}

TEST(Completion, IsAScriptForEachShell) {
  for (const std::string name : {"bash", "zsh", "fish"}) {
    const Outcome script = wend({"completion", name});
    EXPECT_EQ(script.code, 0);
    EXPECT_THAT(script.out, AllOf(HasSubstr("wend"), HasSubstr("random_walk")));
    if (shell("command -v " + name).code != 0) continue;
    const Outcome parsed = shell("$WEND completion " + name + " | " + name + " -n");
    EXPECT_EQ(parsed.code, 0) << name << ": " << parsed.err;
  }
  EXPECT_EQ(wend({"completion", "tcsh"}).code, 2);
}

/// What bash offers after these words; the last one is being typed.
std::string completed(const std::string& words, int count) {
  if (shell("command -v bash").code != 0) return "no bash";
  return shell("bash -c 'source <($WEND completion bash); COMP_WORDS=(" + words +
               "); COMP_CWORD=" + std::to_string(count) + "; _wend; echo ${COMPREPLY[*]}'")
      .out;
}

TEST(Completion, BashCompletesSubcommandsFlagsAndValues) {
  if (completed("", 0) == "no bash") GTEST_SKIP() << "there is no bash";
  EXPECT_EQ(completed("wend pl", 1), "plan planners\n");
  EXPECT_EQ(completed("wend plan --lim", 2), "--limit-memory --limit-expansions --limit-time\n");
  EXPECT_EQ(completed("wend plan --nearest --lim", 3),
            "--limit-memory --limit-expansions --limit-time\n");
  EXPECT_EQ(completed("wend plan --planner d", 3), "dijkstra dfs d_star_lite\n");
  EXPECT_EQ(completed("wend plan --planner = d", 4), "dijkstra dfs d_star_lite\n");
  EXPECT_EQ(completed("wend plan --corner-rule \"\"", 3), "none one both\n");
  EXPECT_EQ(completed("wend plan --show p", 3), "parent policy\n");
  EXPECT_EQ(completed("wend view --show g,cl", 3), "g,closed g,clearance\n");
  EXPECT_EQ(completed("wend view --style dark,p", 3), "dark,print\n");
  EXPECT_EQ(completed("wend compare --planner bfs,d", 3), "bfs,dijkstra bfs,dfs bfs,d_star_lite\n");
  EXPECT_EQ(completed("wend generate ma", 2), "maze\n");
  EXPECT_EQ(completed("wend convert --st", 2), "--strict\n");
  EXPECT_EQ(completed("wend completion \"\"", 2), "bash zsh fish\n");
  EXPECT_EQ(completed("wend plan --start \"\"", 3), "\n");
}

/// The lines of a text that are commands, as a user would type them.
std::vector<std::string> commands_in(const std::string& text, const std::string& indent) {
  std::vector<std::string> commands;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(indent + "wend ")) commands.push_back(line.substr(indent.size() + 5));
  }
  return commands;
}

/// The same of a page's shell blocks.
std::vector<std::string> commands_in_blocks(const std::string& page) {
  std::string blocks;
  std::istringstream lines(page);
  bool in_block = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      in_block = line == "```sh";
    } else if (in_block) {
      blocks += line + '\n';
    }
  }
  return commands_in(blocks, "");
}

/// A folder with the files that examples take for granted.
class Examples : public testing::Test {
 protected:
  void SetUp() override {
    const std::string queries = "version 1\n0 arena.map 50 50 1 1 4 1 3\n";
    for (const std::string file : {"arena.map.scen", "den520d.map.scen", "queries.scen"}) {
      folder_.write(file, queries);
    }
    std::string arena = "type octile\nheight 50\nwidth 50\nmap\n";
    std::string grid;
    for (int y = 0; y < 50; ++y) arena += std::string(50, '.') + "\n";
    for (int y = 0; y < 10; ++y) grid += std::string(10, '.') + "\n";
    folder_.write("course.txt", "..#...\n......\n..#.#.\n..#.#.\n..#.#.\n");
    folder_.write("arena.map", arena);
    folder_.write("den520d.map", arena);
    folder_.write("grid.txt", grid);
    folder_.write("queries.csv", "start_x,start_y,goal_x,goal_y\n1,1,15,9\n15,9,2,2.5\n");
    expect_to_work("index build arena.map -o arena.idx");
  }

  void expect_to_work(const std::string& command) const {
    const Outcome outcome = shell("cd " + (folder_ / "").string() +
                                  " && wend() { \"$WEND\" \"$@\"; } && wend " + command);
    // What is explained may be that there is no path.
    const bool worked = outcome.code == 0 || (outcome.code == 1 && command.starts_with("explain "));
    EXPECT_TRUE(worked) << "wend " << command << "\n" << outcome.code << ": " << outcome.err;
  }

  TemporaryFolder folder_;
};

TEST_F(Examples, OfTheHelpWork) {
  expect_to_work("generate office --size 160x100 --seed 7 -o office.yaml");
  for (const std::string name :
       {"info", "plan", "explain", "field", "bench", "planners", "generate", "convert"}) {
    const auto commands = commands_in(wend({name, "--help-all"}).out, "  ");
    EXPECT_GE(commands.size(), 2U) << name;
    for (const std::string& command : commands) expect_to_work(command);
  }
}

TEST_F(Examples, OfTheDocumentationWork) {
  const auto commands = commands_in_blocks(bytes_of(source_folder() / "docs/command_line.md"));
  EXPECT_GE(commands.size(), 10U);
  for (const std::string& command : commands) expect_to_work(command);
}

TEST_F(Examples, OfTheReadmeAndTheTourWorkInTheirOrder) {
  for (const auto& [page, fewest] :
       {std::pair{"/README.md", 3U}, {"/docs/getting_started.md", 15U}}) {
    const std::string text = bytes_of(source_folder().string() + page);
    const auto commands = commands_in_blocks(text);
    EXPECT_GE(commands.size(), fewest) << page;
    for (const std::string& command : commands) expect_to_work(command);
    EXPECT_LT(text.find("\nexport PATH="), text.find("\nwend generate"))
        << page << ": wend is on the PATH before it is called";
  }
}

}  // namespace
}  // namespace wend::test
