// Ctrl-C, from outside: whatever the program does, it ends with code 130 and leaves no file behind.

#include <gmock/gmock.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/command_line/corridor_grid.hpp"
#include "tests/command_line/run_program.hpp"
#include "tests/testing/build_paths.hpp"
#include "wend/base/random.hpp"

namespace wend::test {
namespace {

/// The program, running; what it writes goes nowhere.
class Running {
 public:
  explicit Running(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program());
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
      posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
    }
    const int failure = posix_spawn(&child_, arguments[0].c_str(), &actions, nullptr,
                                    pointers_to(arguments).data(), environ);
    EXPECT_EQ(failure, 0);
    posix_spawn_file_actions_destroy(&actions);
  }

  /// Until it has computed for some tenths of a second: its files are read then, and it is at what
  /// takes hours. False if it ended before.
  bool wait_until_it_is_at_work() {
    constexpr long kTicks = 30;
    while (ticks() < kTicks) {
      if (waitpid(child_, &status_, WNOHANG) != 0) return false;
      std::this_thread::yield();
    }
    return true;
  }

  Outcome interrupt() {
    kill(child_, SIGINT);
    waitpid(child_, &status_, 0);
    Outcome outcome;
    set_end(outcome, status_);
    return outcome;
  }

 private:
  /// Of processor time, as Linux counts it.
  long ticks() const {
    std::ifstream stat("/proc/" + std::to_string(child_) + "/stat");
    std::string line;
    std::getline(stat, line);
    std::istringstream fields(line.substr(line.rfind(')') + 1));
    std::string field;
    constexpr int kBefore = 11;  // from the state to what comes before utime
    for (int i = 0; i < kBefore; ++i) fields >> field;
    long ticks = 0;
    fields >> ticks;
    return ticks;
  }

  pid_t child_ = 0;
  int status_ = 0;
};

/// There are more rows than are answered in minutes, and the first is answered at once.
TEST(InterruptedQueries, ReportWhatWasAnswered) {
  const TemporaryFolder folder;
  std::string grid;
  for (int y = 0; y < 200; ++y) grid += std::string(200, '.') + "\n";
  const std::string map = folder.write("open.txt", grid);
  constexpr int kRows = 100000;
  std::string rows = "start,goal\n\"0,0\",\"1,0\"\n";
  for (int i = 1; i < kRows; ++i) rows += "\"0,0\",\"199,199\"\n";
  const std::string queries = folder.write("queries.csv", rows);
  const std::string answers = folder / "answers.csv";
  Running program({"plan", map, "--queries", queries, "--planner", "dijkstra:leaps=false",
                   "--threads", "1", "-o", answers});
  ASSERT_TRUE(program.wait_until_it_is_at_work()) << "it ended by itself";
  const Outcome outcome = program.interrupt();
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.code, 130);
  std::ifstream written(answers);
  std::string line;
  int found = 0;
  int cancelled = 0;
  std::getline(written, line);
  EXPECT_THAT(line, testing::StartsWith("line,start,goal,status,reason"));
  while (std::getline(written, line)) {
    found += line.find(",found,") != std::string::npos ? 1 : 0;
    cancelled += line.find(",cancelled,") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(found, 0);
  EXPECT_GT(cancelled, 0);
  EXPECT_EQ(found + cancelled, kRows);  // every row has an answer
}

struct LongCommand {
  std::string name;
  std::vector<std::string> arguments;
};

class Interrupt : public testing::TestWithParam<LongCommand> {
 protected:
  /// MAP, LARGE, NOISE and PATH are files, OUT is one that is to be written.
  std::vector<std::string> with_files(std::vector<std::string> arguments) const {
    for (std::string& argument : arguments) {
      if (argument == "MAP") argument = map_;
      if (argument == "LARGE") argument = large_;
      if (argument == "NOISE") argument = noise_;
      if (argument == "PATH") argument = path_;
      if (argument == "OUT") argument = folder_ / "out.json";
    }
    return arguments;
  }

  static std::string large_grid() {
    std::string grid;
    for (int y = 0; y < 2000; ++y) grid += std::string(2000, '.') + "\n";
    return grid;
  }

  /// A third of its cells are blocked.
  static std::string noise() {
    Random random(1);
    std::string grid;
    for (int y = 0; y < 700; ++y) {
      for (int x = 0; x < 700; ++x) grid += random.chance(0.33) ? '#' : '.';
      grid += "\n";
    }
    return grid;
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kCorridorGrid);
  std::string large_ = folder_.write("large.txt", large_grid());
  std::string noise_ = folder_.write("noise.txt", noise());
  std::string path_ = folder_.write("path.csv", "# x_m,y_m\n1,1\n500,2\n500,500\n");
};

TEST_P(Interrupt, EndsWith130AndWritesNothing) {
  Running program(with_files(GetParam().arguments));
  ASSERT_TRUE(program.wait_until_it_is_at_work()) << "it ended by itself";
  const Outcome outcome = program.interrupt();
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.code, 130);
  std::vector<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(folder_ / "")) {
    files.push_back(file.path().filename());
  }
  EXPECT_THAT(files,
              testing::UnorderedElementsAre("grid.txt", "large.txt", "noise.txt", "path.csv"));
}

/// Each would go on for many seconds, most for hours.
INSTANTIATE_TEST_SUITE_P(
    Phases, Interrupt,
    testing::Values(
        LongCommand{"Search",
                    {"plan", "LARGE", "--start", "0,0", "--goal", "1999,1999", "--planner",
                     "random_walk", "--max-steps", "100000000"}},
        LongCommand{"Smoothing",
                    {"smooth", "LARGE", "PATH", "--smoother", "curvature", "--turning-radius",
                     "100000", "--max-sweeps", "1000000000", "-o", "OUT"}},
        LongCommand{
            "Simulation",
            {"follow", "MAP", "--start", "0,0", "--goal", "9,4", "--speed", "0.001", "--rate",
             "10000", "--time-limit", "1000000", "--stuck-time", "1000000", "-o", "OUT"}},
        LongCommand{
            "Comparison",
            {"compare", "LARGE", "--planner", "dijkstra", "--random", "1000000", "-o", "OUT"}},
        LongCommand{"Index", {"index", "build", "NOISE", "--threads", "1", "-o", "OUT"}}),
    [](const auto& test) { return test.param.name; });

TEST(Resampling, SaysItsLimit) {
  const TemporaryFolder folder;
  const std::string map = folder.write("grid.txt", kCorridorGrid);
  const Outcome outcome =
      wend({"plan", map, "--start", "0,0", "--goal", "9,4", "--resample", "1e-6"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, testing::HasSubstr("1000000 is the limit"));
}

}  // namespace
}  // namespace wend::test
