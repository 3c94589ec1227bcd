// Files in and out of the program: standard input and output, pipes, lists of queries, and large maps.

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"
#include "tests/command_line/walled_off_grid.hpp"
#include "tests/testing/build_paths.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Streams : public testing::Test {
 protected:
  /// A line of bash, which knows <( ), in the folder.
  Outcome bash(const std::string& line) const {
    return run_program({"/bin/bash", "-c", "cd " + (folder_ / "").string() + " && " + line},
                       {"WEND=" + program()});
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kWalledOff);
};

constexpr const char* kEnds = " --start 0,0 --goal 4,3 ";
constexpr const char* kPath =
    "x,y,x_m,y_m\n0,0,0.5,0.5\n0,1,0.5,1.5\n0,2,0.5,2.5\n1,2,1.5,2.5\n2,2,2.5,2.5\n3,3,3.5,3.5\n"
    "4,3,4.5,3.5\n";

TEST_F(Streams, APathComesOutOfStandardOutputAndNothingElse) {
  const std::string ends = kEnds;
  for (const std::string& flags :
       {std::string("-o -"), std::string("-o - --format csv"), std::string("--format csv")}) {
    const Outcome planned = bash("$WEND plan grid.txt" + ends + flags);
    EXPECT_EQ(planned.out, kPath) << flags << planned.err;
  }
  const json plan = json::parse(bash("$WEND plan grid.txt" + ends + "-o - --format json").out);
  EXPECT_EQ(plan.at("path").size(), 7U);
  const Outcome failed = bash("$WEND plan grid.txt --start 0,0 --goal 6,0 -o -");
  EXPECT_EQ(failed.code, 1);
  EXPECT_THAT(failed.out, StartsWith("# no path: unreachable: "));
  EXPECT_EQ(bash("$WEND plan grid.txt" + ends + "-o - -o -").code, 2);
  EXPECT_EQ(bash("$WEND plan grid.txt" + ends + "-o - --step").code, 2);
  EXPECT_EQ(bash("$WEND plan grid.txt" + ends + "--threads 2").code, 2) << "without --queries";
}

TEST_F(Streams, AMapIsReadFromStandardInputAndFromPipes) {
  const std::string ends = kEnds;
  for (const std::string& command :
       {"cat grid.txt | $WEND plan -" + ends + "-o -", "$WEND plan - < grid.txt" + ends + "-o -",
        "cat grid.txt | $WEND plan /dev/stdin" + ends + "-o -",
        "$WEND plan <(cat grid.txt)" + ends + "-o -",
        "mkfifo pipe.txt && (cat grid.txt > pipe.txt & $WEND plan pipe.txt" + ends + "-o -)"}) {
    const Outcome planned = bash(command);
    EXPECT_EQ(planned.out, kPath) << command << planned.err;
  }
}

TEST_F(Streams, EveryMapThatIsOneFileComesThroughAPipe) {
  ASSERT_EQ(bash("$WEND generate maze --size 21x11 --seed 3 -o m.map -o m.png -o m.pgm").code, 0);
  for (const std::string name : {"m.map", "m.png", "m.pgm"}) {
    const Outcome info = bash("cat " + name + " | $WEND info - --format json");
    ASSERT_EQ(info.code, 0) << info.err;
    EXPECT_EQ(json::parse(info.out).at("width"), 21) << name;
  }
  EXPECT_EQ(json::parse(bash("$WEND generate maze --size 21x11 | $WEND info - --format json").out)
                .at("format"),
            "text grid");
}

TEST_F(Streams, AGeneratedMapIsPlannedOn) {
  const Outcome planned = bash("$WEND generate maze | $WEND plan - --start 1,1 --goal 39,19 -o -");
  EXPECT_EQ(planned.code, 0) << planned.err;
  EXPECT_THAT(planned.out, AllOf(HasSubstr("\n1,1,1.5,1.5\n"), EndsWith("\n39,19,39.5,19.5\n")));
}

TEST_F(Streams, AMapYamlFindsItsImageInTheWorkingFolder) {
  ASSERT_EQ(bash("$WEND generate maze --size 21x11 -o m.yaml").code, 0);
  EXPECT_EQ(bash("$WEND info - < m.yaml").code, 0);
  EXPECT_EQ(bash("$WEND info <(cat m.yaml)").code, 0);
  const Outcome elsewhere = bash("mkdir sub && cd sub && cat ../m.yaml | $WEND info -");
  EXPECT_EQ(elsewhere.code, 2);
  EXPECT_THAT(elsewhere.err, HasSubstr("standard input: image m.png: cannot be opened"));
}

TEST_F(Streams, EverySubcommandWithAMapReadsIt) {
  folder_.write("plan.csv", kPath);
  const std::string ends = kEnds;
  for (const std::string& command : std::vector<std::string>{
           "info -", "view - --picture always", "convert - out.map", "field - --goal 4,3",
           "compare -" + ends, "check - plan.csv", "smooth - plan.csv", "follow - --path plan.csv",
           "follow -" + ends}) {
    const Outcome outcome = bash("cat grid.txt | $WEND " + command);
    EXPECT_EQ(outcome.code, 0) << command << outcome.err;
  }
  EXPECT_EQ(bash("cat grid.txt | $WEND explain - --start 0,0 --goal 6,0").code, 1);
}

TEST_F(Streams, EverySubcommandWithAPathReadsIt) {
  folder_.write("plan.csv", kPath);
  for (const std::string command :
       {"check grid.txt -", "smooth grid.txt -", "view grid.txt -", "follow grid.txt --path -"}) {
    const Outcome outcome = bash("cat plan.csv | $WEND " + command);
    EXPECT_EQ(outcome.code, 0) << command << outcome.err;
  }
  const std::string ends = kEnds;
  const Outcome chain =
      bash("$WEND plan grid.txt" + ends + "-o - | $WEND smooth grid.txt - -o - | " +
           "$WEND check <(cat grid.txt) - --format json");
  EXPECT_EQ(chain.code, 0) << chain.err;
  EXPECT_EQ(json::parse(chain.out).at("free"), true);
}

TEST_F(Streams, StandardInputIsReadOnce) {
  for (const std::string command :
       {"check - -", "smooth - /dev/stdin", "view - -", "view - --beside -", "follow - --path -",
        "plan - --queries -"}) {
    const Outcome refused = bash("cat grid.txt | $WEND " + command);
    EXPECT_EQ(refused.code, 2) << command;
    EXPECT_THAT(refused.err, HasSubstr("standard input can be read only once")) << command;
  }
}

TEST_F(Streams, ErrorsNameStandardInput) {
  EXPECT_EQ(bash("printf '..\\n.x\\n' | $WEND info -").err,
            "wend: standard input:2: unknown letter 'x' in column 2\n");
  EXPECT_THAT(bash("printf 'hello' | $WEND info -").err,
              StartsWith("wend: standard input: unknown map format"));
  EXPECT_EQ(bash("$WEND info - < /dev/null").err,
            "wend: standard input: the file is empty; expected a map\n");
  EXPECT_EQ(bash("$WEND info . ").code, 2);
}

/// Names of files reach a terminal without what could move its cursor.
TEST_F(Streams, NamesOnStandardOutputAreVisible) {
  const std::string evil = "$'\\e]0;title\\a'";
  for (const std::string& command :
       {"$WEND generate maze --size 9x9 -o " + evil + ".txt", "$WEND info " + evil + ".txt",
        "$WEND convert " + evil + ".txt " + evil + ".map",
        "$WEND generate scenario " + evil + ".map --buckets 2 -o a.map.scen",
        "$WEND generate scenario " + evil + ".map --buckets 2 -o " + evil + ".map.scen",
        "$WEND bench " + evil + ".map.scen", "$WEND view " + evil + ".txt",
        "$WEND index build " + evil + ".map -o " + evil + ".idx",
        "$WEND index info " + evil + ".idx"}) {
    const Outcome outcome = bash(command);
    EXPECT_EQ(outcome.code, 0) << command << outcome.err;
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("\x1b]"))) << command;
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("\x07"))) << command;
  }
}

TEST_F(Streams, TheMapThatStandardInputCameFromIsNotWrittenOver) {
  const Outcome refused = bash("$WEND convert - grid.txt < grid.txt");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("this file is also an input"));
  EXPECT_EQ(bytes_of(map_), kWalledOff);
}

TEST_F(Streams, AMapIsWrittenToStandardOutputAsATextGrid) {
  EXPECT_EQ(bash("$WEND convert grid.txt -").out, ".....#.\n.###.#.\n....##.\n.23..#?\n");
  EXPECT_EQ(bash("$WEND generate maze --size 21x11 -o -").out,
            bash("$WEND generate maze --size 21x11").out);
}

class Queries : public Streams {
 protected:
  std::string queries_ = folder_.write("queries.csv",
                                       "id,start_x,start_y,goal_x,goal_y\n"
                                       "a,0,0,4,3\n"
                                       "b,0,0,6,0\n"
                                       "c,0,0\n"
                                       "d,0,0,1,1\n"
                                       "e,0,x,4,3\n"
                                       "\n"
                                       "f,4,3,0,0\n");
};

TEST_F(Queries, EveryRowHasAnAnswerInItsPlace) {
  const Outcome run =
      bash("$WEND plan grid.txt --queries queries.csv -o answers.csv -o answers.json");
  EXPECT_EQ(run.code, 1) << "not every row has a path";
  EXPECT_THAT(run.out,
              HasSubstr("6 queries: 2 found, 1 goal_blocked, 2 invalid_query, 1 unreachable\n"));
  const json answers = json::parse(bytes_of(folder_ / "answers.json"));
  EXPECT_EQ(answers.at("schema"), 1);
  EXPECT_EQ(answers.at("planner"), "astar");
  const json& rows = answers.at("answers");
  ASSERT_EQ(rows.size(), 6U);
  const std::vector<std::string> statuses{"found",        "unreachable",   "invalid_query",
                                          "goal_blocked", "invalid_query", "found"};
  for (std::size_t i = 0; i < statuses.size(); ++i) EXPECT_EQ(rows[i].at("status"), statuses[i]);
  EXPECT_EQ(rows[0].at("path").size(), 7U);
  EXPECT_EQ(rows[0].at("cost"), rows[5].at("cost"));
  EXPECT_EQ(rows[2].at("reason"), "line 4: 3 columns, expected 5 as in the header");
  EXPECT_EQ(rows[4].at("reason"), "line 6: start: '0,x' is not X,Y, two finite numbers");
  EXPECT_EQ(rows[5].at("line"), 8);
  EXPECT_EQ(rows[1].at("cost"), nullptr);
  const std::string csv = bytes_of(folder_ / "answers.csv");
  EXPECT_THAT(csv, StartsWith("line,start,goal,status,reason,cost,length_cells,length_m,expanded,"
                              "search_us,start_shift_m,goal_shift_m\n2,\"0,0\",\"4,3\",found,,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
}

TEST_F(Queries, SayHowFarTheEndsMovedAsPlanDoes) {
  ASSERT_EQ(bash("$WEND generate office --size 160x100 --seed 7 -o office.yaml").code, 0);
  folder_.write("office.csv", "start;goal\n1,1;15,9\n1.05,1.05;1.15,1.25\n1,1;0,0\n");
  const Outcome outcome =
      bash("$WEND plan office.yaml --queries office.csv -o office_answers.csv -o - --format json");
  const json rows = json::parse(outcome.out).at("answers");
  const std::vector<std::string> ends{"--start 1,1 --goal 15,9",
                                      "--start 1.05,1.05 --goal 1.15,1.25"};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const json plan = json::parse(bash("$WEND plan office.yaml --format json " + ends[i]).out);
    EXPECT_EQ(rows[i].at("start_shift"), plan.at("start_shift"));
    EXPECT_EQ(rows[i].at("goal_shift"), plan.at("goal_shift"));
  }
  EXPECT_EQ(rows[0].at("start_shift").at("m"), 0) << "it begins where it was asked to";
  EXPECT_EQ(rows[1].at("start_shift").at("m"), 0);
  EXPECT_EQ(rows[2].at("start_shift"), nullptr);
  const std::string csv = bytes_of(folder_ / "office_answers.csv");
  EXPECT_THAT(csv, testing::EndsWith(",,\n"));
}

TEST_F(Queries, ThreadsChangeNothingButTheTimes) {
  std::string queries = "start;goal\n";
  for (int i = 0; i < 500; ++i) {
    queries += std::to_string(i % 5) + "," + std::to_string(i % 4) + ";4,3\n";
  }
  folder_.write("many.csv", queries);
  const auto answers = [this](const std::string& threads) {
    json rows =
        json::parse(
            bash("$WEND plan grid.txt --queries many.csv --format json --threads " + threads).out)
            .at("answers");
    for (json& row : rows) row.erase("search_us");
    return rows;
  };
  EXPECT_EQ(answers("1"), answers("3"));
}

TEST_F(Queries, TheAnswersAgreeWithThoseOfSingleCommands) {
  const json rows =
      json::parse(
          bash("$WEND plan grid.txt --queries queries.csv --planner dijkstra -o - --format json")
              .out)
          .at("answers");
  const json single = json::parse(
      bash("$WEND plan grid.txt --planner dijkstra --start 4,3 --goal 0,0 --format json").out);
  for (const char* const key : {"cost", "path", "length_cells", "length_m"}) {
    EXPECT_EQ(rows[5].at(key), single.at(key)) << key;
  }
}

TEST_F(Queries, ComeFromPipesAndGoToThem) {
  const Outcome run = bash("cat queries.csv | $WEND plan grid.txt --queries - -o - | head -n 2");
  EXPECT_THAT(run.out, AllOf(StartsWith("line,start,goal,status"), HasSubstr("\n2,\"0,0\"")));
}

TEST_F(Queries, BlockedEndsMoveWhenAsked) {
  const json rows =
      json::parse(bash("$WEND plan grid.txt --queries queries.csv --nearest --format json").out)
          .at("answers");
  EXPECT_EQ(rows[3].at("status"), "found");
  EXPECT_THAT(rows[3].at("reason"), HasSubstr("goal"));
}

TEST_F(Queries, OfACarHaveHeadings) {
  folder_.write("open.txt", "......\n......\n......\n......\n");
  folder_.write("car.csv", "start,goal\n\"0,0,E\",\"5,3,any\"\n\"0,0,Q\",\"5,3,any\"\n");
  const json rows =
      json::parse(bash("$WEND plan open.txt --planner car --queries car.csv --format json").out)
          .at("answers");
  EXPECT_EQ(rows[0].at("status"), "found");
  EXPECT_EQ(rows[0].at("headings").at(0), "E");
  EXPECT_EQ(rows[1].at("status"), "invalid_query");
}

TEST_F(Queries, RefuseWhatIsAboutOneQuery) {
  for (const std::string flags : {"--start 0,0", "--show g", "--smooth", "--trace a.trace.json",
                                  "-o plan.png", "--threads 99999", "--threads 0"}) {
    const Outcome refused = bash("$WEND plan grid.txt --queries queries.csv " + flags);
    EXPECT_EQ(refused.code, 2) << flags;
    EXPECT_THAT(refused.out, IsEmpty()) << flags;
  }
  EXPECT_THAT(bash("$WEND plan grid.txt --queries queries.csv -o queries.csv").err,
              HasSubstr("-o queries.csv: this file is also an input and would be overwritten"));
  folder_.write("bad.csv", "from,to\n1,2\n");
  EXPECT_THAT(bash("$WEND plan grid.txt --queries bad.csv").err,
              HasSubstr("bad.csv:1: the first line must name the columns start_x and start_y"));
  EXPECT_THAT(bash("$WEND plan grid.txt --start 0,0").err, HasSubstr("--goal is required"));
}

TEST_F(Queries, MayBeNone) {
  folder_.write("none.csv", "start,goal\n");
  const Outcome run = bash("$WEND plan grid.txt --queries none.csv -o answers.csv");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, "0 queries\n");
  EXPECT_THAT(bytes_of(folder_ / "answers.csv"), StartsWith("line,start,goal,status"));
}

class Memory : public Streams {
 protected:
  /// A map of 8000 columns.
  void write_large_map(int height) const {
    std::string text = "type octile\nheight " + std::to_string(height) + "\nwidth 8000\nmap\n";
    std::string row(8000, '.');
    for (std::size_t x = 0; x < row.size(); x += 7) row[x] = '@';
    for (int y = 0; y < height; ++y) text += row + "\n";
    folder_.write("large.map", text);
  }
};

TEST_F(Memory, InfoNeedsLittleMoreThanTheMap) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer takes more";
#else
  write_large_map(5000);
  const Outcome info = bash("ulimit -v 200000 && $WEND info large.map --format json");
  ASSERT_EQ(info.code, 0) << info.err;
  EXPECT_EQ(json::parse(info.out).at("free"), 6857 * 5000);
  const Outcome for_a_disc =
      bash("ulimit -v 300000 && $WEND info large.map --robot-radius 2 --format json");
  ASSERT_EQ(for_a_disc.code, 0) << for_a_disc.err;
  EXPECT_EQ(json::parse(for_a_disc.out).at("passable"), (2 * 1142 + 3) * 5000);
#endif
}

TEST_F(Memory, WhatDoesNotFitIsRefusedWithTheEstimate) {
  write_large_map(500);
  folder_.write("plan.csv", "old");
  const Outcome refused = bash(
      "$WEND plan large.map --start 1,1 --goal 2,2 --limit-memory 30 -o plan.csv -o plan.json");
  EXPECT_EQ(refused.code, 1);
  EXPECT_EQ(refused.err,
            "wend: large.map: 8000 x 500 cells need about 35 MB of memory, and 30 MB are "
            "available; a coarser map needs less, and --limit-memory MB overrides the check\n");
  EXPECT_THAT(bytes_of(folder_ / "plan.csv"), StartsWith("# no path: memory_limit: large.map: "));
  EXPECT_EQ(json::parse(bytes_of(folder_ / "plan.json")).at("status"), "memory_limit");
  // What a planner takes counts, too.
  EXPECT_EQ(bash("$WEND plan large.map --start 1,1 --goal 2,1 --limit-memory 40 -o -").code, 0);
  EXPECT_THAT(
      bash("$WEND plan large.map --start 1,1 --goal 2,1 --limit-memory 50 --planner bfs").err,
      HasSubstr("need about 67 MB"));
  EXPECT_EQ(bash("$WEND info large.map --limit-memory 0").code, 0) << "a point needs none";
  EXPECT_THAT(bash("$WEND info large.map --robot-radius 400 --limit-memory 10").err,
              HasSubstr("need about 20 MB"));
  EXPECT_THAT(bash("$WEND view large.map --limit-memory 1").err, HasSubstr("need about 3 MB"));
}

/// How often a text stands in another.
std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(MapNotes, AreSaidOnceByEveryCommand) {
  const TemporaryFolder folder;
  folder.write("m.pgm", "P2 5 1 255 254 254 254 205 0\n");
  const std::string map =
      folder.write("m.yaml",
                   "image: /home/someone/m.pgm\nresolution: 1\norigin: [0, 0, 90]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
  const std::vector<std::string> notes = {"beside the map.yaml", "read in radians", "grey 205"};
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"plan", map, "--cells", "--start", "0,0", "--goal", "2,0"},
           {"field", map, "--cells", "--goal", "2,0"},
           {"explain", map, "--cells", "--start", "0,0", "--goal", "2,0"},
           {"view", map},
           {"convert", map, folder / "out.txt"}}) {
    const auto outcome = wend(command);
    for (const std::string& note : notes) {
      EXPECT_EQ(count_of(note, outcome.err), 1U) << command[0] << ": " << outcome.err;
    }
  }
  const auto info = wend({"info", map});
  EXPECT_EQ(count_of("beside the map.yaml", info.err), 1U);
  EXPECT_EQ(count_of("note", info.out), 2U) << info.out;
  const auto report = json::parse(wend({"info", map, "--format", "json"}).out);
  EXPECT_EQ(report["notes"].size(), 3U);
}

}  // namespace
}  // namespace wend::test
