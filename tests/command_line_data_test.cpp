// `wend bench`, and the program on the shared data: bad files, real maps, benchmarks. Without the
// data these are skipped.

#include <gmock/gmock.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): POSIX's part of it

#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr const char* kMap = "type octile\nheight 4\nwidth 5\nmap\n.....\n.@@T.\n.G.S.\n.....\n";

class BenchCommand : public testing::Test {
 protected:
  /// A scenario beside a map of 5 x 4 cells.
  std::string scenario(const std::string& queries, const std::string& name = "ok.map.scen") const {
    folder_.write("ok.map", kMap);
    return folder_.write(name, "version 1\n" + queries);
  }

  static json rows(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "bench");
    arguments.insert(arguments.end(), {"--format", "json"});
    return json::parse(wend(std::move(arguments)).out);
  }

  TemporaryFolder folder_;
};

constexpr const char* kRight =
    "0\tok.map\t5\t4\t0\t0\t4\t0\t4\n1\tok.map\t5\t4\t0\t0\t4\t3\t6.41421356\n";

TEST_F(BenchCommand, HasARowForEachFileAndPlanner) {
  const std::string file = scenario(kRight);
  const std::string other = scenario(kRight, "other.scen");
  const json found = rows({file, other, "--planner", "astar,astar:weight=0,bfs", "--check"});
  ASSERT_EQ(found.size(), 6U);
  const json& row = found.at(0);
  EXPECT_EQ(row.at("scen"), file);
  EXPECT_EQ(row.at("planner"), "astar");
  EXPECT_EQ(found.at(1).at("planner"), "astar:weight=0");
  EXPECT_EQ(row.at("queries"), 2);
  EXPECT_EQ(row.at("solved"), 2);
  EXPECT_EQ(row.at("wrong"), 0);
  EXPECT_EQ(row.size(), 10U);
  for (const char* key :
       {"mean_us", "median_us", "p99_us", "expanded_per_query", "expansions_per_second"}) {
    EXPECT_GT(row.at(key).get<double>(), 0) << key;
  }
  EXPECT_EQ(wend({"bench", file}).code, 0);
  EXPECT_THAT(wend({"bench", file}).out, StartsWith("scenario"));
}

TEST_F(BenchCommand, CountsWhatIsWrong) {
  struct Case {
    std::string query;
    int solved, wrong;
  };
  const std::vector<Case> cases{
      {"0 ok.map 5 4 0 0 4 3 7", 1, 1},        // another length
      {"0 ok.map 5 4 0 0 4 3 6.41427", 1, 0},  // within 1e-5 of it
      {"0 ok.map 5 4 0 0 4 3 6.41", 1, 0},     // two decimals: half a unit
      {"0 ok.map 5 4 0 0 4 3 6.414", 1, 1},    // three decimals: not so
      {"0 ok.map 5 4 0 0 4 3 0", 1, 1},        // the file says that there is none
      {"0 ok.map 5 4 1 1 4 0 4", 0, 1},        // the start is blocked
      {"0 ok.map 5 4 1 1 4 0 0", 0, 0},        // and the file says so
      {"0 ok.map 5 4 2 2 2 2 0", 1, 0},        // nowhere to go
  };
  for (const Case& one : cases) {
    const std::string file = scenario(one.query + "\n");
    const json row = rows({file}).at(0);
    EXPECT_EQ(row.at("solved"), one.solved) << one.query;
    EXPECT_EQ(row.at("wrong"), one.wrong) << one.query;
    const Outcome outcome = wend({"bench", file});
    EXPECT_EQ(outcome.code, one.wrong) << one.query;
    EXPECT_EQ(outcome.err.empty(), one.wrong == 0) << outcome.err;
  }
}

TEST_F(BenchCommand, FindsTheMapOrSaysThatItCannot) {
  EXPECT_EQ(wend({"bench", scenario(kRight)}).code, 0);
  EXPECT_EQ(wend({"bench", scenario(kRight, "any.scen")}).code, 0);
  const std::string lost = scenario("0 maps/lost.map 5 4 0 0 4 0 4\n", "lost.scen");
  const Outcome outcome = wend({"bench", lost});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("its map 'lost.map' is not in the same folder"));
  EXPECT_EQ(wend({"bench", lost, "--map", folder_ / "ok.map"}).code, 0);
}

TEST_F(BenchCommand, RefusesBadInput) {
  const std::string file = scenario(kRight);
  EXPECT_EQ(wend({"bench"}).code, 2);
  EXPECT_EQ(wend({"bench", "no/such.scen"}).code, 2);
  EXPECT_EQ(wend({"bench", file, "--planner", "astr"}).code, 2);
  EXPECT_EQ(wend({"bench", file, "--planner", "astar:weight=x"}).code, 2);
  EXPECT_EQ(wend({"bench", scenario("0 ok.map 5 4 0 0 5 0 4\n")}).code, 2);
  EXPECT_EQ(wend({"bench", scenario("0 ok.map 50 40 0 0 4 0 4\n")}).code, 2);
  const Outcome moves = wend({"bench", scenario(kRight), "--planner", "astar:connectivity=4"});
  EXPECT_EQ(moves.code, 2);
  EXPECT_THAT(moves.err, HasSubstr("without corner cutting"));
}

/// Tests that need the shared data.
class SharedData : public testing::Test {
 protected:
  void SetUp() override {
    if (data_folder().empty()) GTEST_SKIP() << "WEND_DATA is not set";
  }

  static std::string data(const std::string& file) { return data_folder() / file; }
};

TEST_F(SharedData, BadFilesGetTheirVerdicts) {
  std::ifstream table(data("bad/expected.tsv"));
  int checked = 0;
  for (std::string line; std::getline(table, line);) {
    std::istringstream columns(line);
    std::string file;
    std::string verdict;
    columns >> file >> verdict;
    const std::string kind = file.substr(0, file.find('/'));
    const bool scenario = kind == "scen";
    if (!scenario && kind != "map" && kind != "yaml" && kind != "img") continue;
    const std::string path = data("bad/" + file);
    const Outcome outcome =
        scenario ? wend({"bench", path, "--map", data("bad/map/ok.map")}) : wend({"info", path});
    ++checked;
    EXPECT_EQ(outcome.signal, 0) << file;
    const bool refused = outcome.code == 2;
    EXPECT_TRUE(refused || verdict != "reject") << file;
    EXPECT_TRUE(!refused || verdict != "accept") << file << outcome.err;
    if (!refused) continue;
    EXPECT_THAT(outcome.err, AllOf(StartsWith("wend: "), HasSubstr(file))) << file;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << "one line: " << outcome.err;
  }
  EXPECT_GT(checked, 110);
}

TEST_F(SharedData, PlansOnARealRosMap) {
  const TemporaryFolder folder;
  const std::string png = folder / "plan.png";
  const std::vector<std::string> query{"plan",           data("ros/nav2/tb3_sandbox.yaml"),
                                       "--start",        "-2,-0.5",
                                       "--goal",         "1.8,0.6",
                                       "--robot-radius", "0.22"};
  std::vector<std::string> in_json = query;
  in_json.insert(in_json.end(), {"-o", png, "--format", "json"});
  const json plan = json::parse(wend(in_json).out);
  EXPECT_EQ(plan.at("status"), "found");
  EXPECT_NEAR(plan.at("path_m").front().at(0).get<double>(), -2, 0.03);
  EXPECT_NEAR(plan.at("path_m").back().at(1).get<double>(), 0.6, 0.03);
  EXPECT_GT(plan.at("length_m").get<double>(), 3.8);
  EXPECT_THAT(bytes_of(png), StartsWith("\x89PNG"));
  const Outcome text = wend(query);
  EXPECT_THAT(text.out, AllOf(StartsWith("planner"), HasSubstr(" m\n")));
  EXPECT_EQ(text.out.find("\x1b"), std::string::npos);
}

TEST_F(SharedData, SmoothsChecksAndFollowsOnARealRosMap) {
  const TemporaryFolder folder;
  const std::string map = data("ros/nav2/depot.yaml");
  const std::string csv = folder / "smooth.csv";
  const std::vector<std::string> robot{"--robot-radius", "0.25"};
  const auto run = [&robot](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), robot.begin(), robot.end());
    return wend(std::move(arguments));
  };
  ASSERT_EQ(run({"plan", map, "--start", "2,2", "--goal", "28,13", "--smooth", "-o", csv}).code, 0);
  const Outcome checked = run({"check", map, csv, "--format", "json"});
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_GE(json::parse(checked.out).at("metrics").at("smallest_clearance_m").get<double>(),
            0.25 - 1e-9);
  const Outcome driven =
      run({"follow", map, "--start", "2,2", "--goal", "28,13", "--smooth", "--format", "json"});
  EXPECT_EQ(driven.code, 0) << driven.err;
  EXPECT_EQ(json::parse(driven.out).at("drives").at(0).at("collisions"), 0);
}

TEST_F(SharedData, DrivesALapOfARaceTrack) {
  const Outcome outcome =
      wend({"follow", data("tracks/Spielberg_map.yaml"), "--path",
            data("tracks/Spielberg_centerline.csv"), "--loop", "--robot-radius", "0.3", "--speed",
            "3", "--drivetrain", "bicycle", "--format", "json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json drive = json::parse(outcome.out).at("drives").at(0);
  EXPECT_EQ(drive.at("collisions"), 0);
  EXPECT_NEAR(drive.at("distance_m").get<double>(), 343, 5);
  const Outcome raceline = wend({"check", data("tracks/Spielberg_map.yaml"),
                                 data("tracks/Spielberg_raceline.csv"), "--format", "json"});
  EXPECT_EQ(raceline.code, 0) << raceline.err;
  EXPECT_NEAR(json::parse(raceline.out).at("metrics").at("length_m").get<double>(), 338, 2);
}

TEST_F(SharedData, ARobotThatIsTooLargeIsToldWhy) {
  const Outcome outcome = wend({"plan", data("ros/nav2/tb3_sandbox.yaml"), "--start", "-2,-0.5",
                                "--goal", "1.8,0.6", "--robot-radius", "0.6"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("the robot's radius is 0.6 m"), HasSubstr("--nearest")));
}

TEST_F(SharedData, SolvesABenchmarkWithNothingWrong) {
  const Outcome outcome = wend({"bench", data("movingai/mapf/empty-32-32-even-1.scen"),
                                data("movingai/dao/den011d.map.scen"), "--check"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

/// A terminal that the test watches: everything that is written to it comes out of `read()`.
class PseudoTerminal {
 public:
  PseudoTerminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    grantpt(master_);
    unlockpt(master_);
  }
  ~PseudoTerminal() { close(master_); }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  std::string name() const { return ptsname(master_); }

  /// Reads until the text has come; false if the other end was closed before.
  bool wait_for(const std::string& text) {
    std::string seen;
    char buffer[512];
    while (seen.find(text) == std::string::npos) {
      const ssize_t count = ::read(master_, buffer, sizeof buffer);
      if (count <= 0) return false;
      seen.append(buffer, static_cast<std::size_t>(count));
    }
    return true;
  }

 private:
  int master_;
};

/// A large empty map and a walk on it that takes for ever.
std::vector<std::string> endless_walk(const TemporaryFolder& folder) {
  const std::string row = std::string(2000, '.') + "\n";
  std::string grid;
  for (int y = 0; y < 2000; ++y) grid += row;
  return {WEND_CLI_PATH, "plan",      folder.write("grid.txt", grid),
          "--start",     "0,0",       "--goal",
          "1999,1999",   "--planner", "random_walk",
          "--max-steps", "100000000", "--format",
          "json"};
}

TEST(Interrupt, CancelsTheSearch) {
  const TemporaryFolder folder;
  PseudoTerminal terminal;
  std::vector<std::string> arguments = endless_walk(folder);
  const std::string out = folder / "out";
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, terminal.name().c_str(),
                                   O_WRONLY | O_NOCTTY, 0);
  pid_t child = 0;
  ASSERT_EQ(
      posix_spawn(&child, WEND_CLI_PATH, &actions, nullptr, pointers_to(arguments).data(), environ),
      0);
  posix_spawn_file_actions_destroy(&actions);
  // The progress bar shows that the search is on.
  ASSERT_TRUE(terminal.wait_for("planning "));
  kill(child, SIGINT);
  EXPECT_TRUE(terminal.wait_for("cancelled after"));
  int wait_status = 0;
  ASSERT_EQ(waitpid(child, &wait_status, 0), child);
  Outcome outcome;
  set_end(outcome, wait_status);
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(json::parse(bytes_of(out)).at("status"), "cancelled");
}

/// What a plan looks like on a terminal of that kind.
std::string seen_on_terminal(const std::string& environment) {
  if (shell("command -v script").code != 0) return {};
  const TemporaryFolder folder;
  const std::string map = folder.write("grid.txt", "....\n.##.\n....\n");
  const std::string log = folder / "log";
  shell(environment + " script -qec \"$WEND plan " + map + " --start 0,0 --goal 3,2\" " + log +
        " >/dev/null");
  return bytes_of(log);
}

TEST(Terminal, IsColouredUnlessNoColorIsSet) {
  const std::string coloured = seen_on_terminal("env -u NO_COLOR TERM=xterm-256color");
  if (coloured.empty()) GTEST_SKIP() << "there is no script(1)";
  EXPECT_NE(coloured.find("\x1b["), std::string::npos);
  const std::string plain = seen_on_terminal("env NO_COLOR=1 TERM=xterm-256color");
  EXPECT_THAT(plain, HasSubstr("(0,0)>"));
  EXPECT_EQ(plain.find("\x1b["), std::string::npos);
}

}  // namespace
}  // namespace wend::test
