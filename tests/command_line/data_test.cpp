// The program on the shared data: bad files, real maps, benchmarks. Without the data these are
// skipped.

#include <gmock/gmock.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): POSIX's part of it

#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/command_line/run_program.hpp"
#include "tests/testing/build_paths.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

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
  EXPECT_NEAR(plan.at("path_m").front().at(0).get<double>(), -2, 1e-9);
  EXPECT_NEAR(plan.at("path_m").back().at(1).get<double>(), 0.6, 1e-9);
  EXPECT_GT(plan.at("length_m").get<double>(), 3.8);
  EXPECT_THAT(bytes_of(png), StartsWith("\x89PNG"));
  const Outcome text = wend(query);
  EXPECT_THAT(text.out,
              AllOf(StartsWith("planner"), HasSubstr(" m\n"), Not(HasSubstr("middles of cells"))));
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
  return {program(),     "plan",      folder.write("grid.txt", grid),
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
  ASSERT_EQ(posix_spawn(&child, program().c_str(), &actions, nullptr, pointers_to(arguments).data(),
                        environ),
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
  EXPECT_EQ(outcome.code, 130);
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
