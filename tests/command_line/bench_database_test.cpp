// `wend bench --database`: what it keeps, and how a run that was interrupted goes on.

#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include "tests/command_line/bench_folder.hpp"
#include "tests/command_line/database_number.hpp"
#include "tests/testing/build_paths.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class BenchDatabaseCommand : public testing::Test, protected BenchFolder {
 protected:
  std::string database_ = folder_ / "bench.db";
};

TEST_F(BenchDatabaseCommand, KeepsEveryAnswer) {
  const std::string file = scenario(kRight);
  const json all =
      rows({file, "--planner", "astar,bfs", "--repetitions", "2", "--database", database_});
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM runs"), 4);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM passes"), 8);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM experiments WHERE name = 'ok'"), 1);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM plannerConfigs"), 2);
  EXPECT_EQ(number_in(database_, "SELECT sum(solved) FROM runs"), 4);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM runs WHERE time > 0 AND time < 1"), 4);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM runs WHERE first_s > 0 AND prepare_s > 0"),
            4);
  EXPECT_EQ(number_in(database_,
                      "SELECT count(*) FROM experiments WHERE version LIKE 'wend %' AND "
                      "length(commit_hash) > 6"),
            1);
}

TEST_F(BenchDatabaseCommand, KeepsThePathsOfAnytimePlanners) {
  const std::string file = scenario(kRight);
  rows({file, "--planner", "ara_star,astar", "--repetitions", "2", "--database", database_});
  const std::string of_ara_star =
      " FROM progress JOIN runs ON runid = runs.id JOIN plannerConfigs ON plannerid = "
      "plannerConfigs.id WHERE name = 'ara_star'";
  EXPECT_EQ(number_in(database_, "SELECT count(DISTINCT runid)" + of_ara_star), 2);
  EXPECT_EQ(number_in(database_, "SELECT count(DISTINCT runid) FROM progress"), 2);
  EXPECT_EQ(
      number_in(database_,
                "SELECT count(*) FROM runs WHERE abs(solution_length - (SELECT min(best_cost) "
                "FROM progress WHERE runid = runs.id)) < 1e-9"),
      2)
      << "the last path is the answer";
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM progress WHERE time > 0 AND time < 1"),
            number_in(database_, "SELECT count(*) FROM progress"));
}

TEST_F(BenchDatabaseCommand, DoesNothingTwice) {
  const std::string file = scenario(kRight);
  const std::vector<std::string> command{"bench",      file,      "--planner", "astar,bfs",
                                         "--database", database_, "--format",  "json"};
  const Outcome first = wend(command);
  EXPECT_THAT(first.err, IsEmpty());
  const Outcome again = wend(command);
  EXPECT_THAT(again.err, HasSubstr("4 of 4 answers were already stored"));
  EXPECT_EQ(json::parse(first.out), json::parse(again.out));
}

TEST_F(BenchDatabaseCommand, AddsWhatIsMissing) {
  const std::string file = scenario(kRight);
  rows({file, "--sample", "1", "--database", database_});
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM runs"), 1);
  const std::vector<std::string> more{file, "--repetitions", "3", "--database", database_};
  EXPECT_EQ(rows(more).at(0).at("passes"), 3);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM runs"), 2);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM passes"), 6);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM experiments"), 1);
  scenario("0 ok.map 5 4 0 0 1 0 1\n");  // another scenario in a file of the same name
  rows(more);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM experiments"), 2);
}

TEST_F(BenchDatabaseCommand, NeverMixesWhatWasMeasuredUnderOtherConditions) {
  const std::string file = scenario(kRight);
  const std::vector<std::vector<std::string>> conditions{
      {}, {"--fresh"}, {"--limit-time", "5"}, {"--robot-radius", "0.1"}, {"--connectivity", "4"}};
  int experiments = 0;
  for (std::vector<std::string> words : conditions) {
    words.insert(words.begin(), {file, "--database", database_});
    EXPECT_EQ(rows(words).at(0).at("wrong"), 0);
    EXPECT_EQ(number_in(database_, "SELECT count(*) FROM experiments"), ++experiments);
  }
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM experiments WHERE timelimit = 5"), 1);
}

TEST_F(BenchDatabaseCommand, RemembersWhatWasWrong) {
  const std::string file = scenario("0 ok.map 5 4 0 0 4 3 7\n");
  EXPECT_EQ(wend({"bench", file, "--database", database_}).code, 1);
  const Outcome again = wend({"bench", file, "--database", database_});
  EXPECT_EQ(again.code, 1);
  EXPECT_EQ(number_in(database_, "SELECT correct_solution FROM runs"), 0);
}

TEST_F(BenchDatabaseCommand, RefusesAForeignFileAndLeavesItAlone) {
  const std::string file = scenario(kRight);
  const std::string foreign = folder_.write("notes.txt", kBenchMap);
  const Outcome outcome = wend({"bench", file, "--database", foreign});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("notes.txt: file is not a database"));
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_EQ(bytes_of(foreign), kBenchMap);
  const Outcome map = wend({"bench", file, "--database", folder_ / "ok.map"});
  EXPECT_EQ(map.code, 2);
  EXPECT_THAT(map.err, HasSubstr("ok.map: this file is also an input"));
  EXPECT_EQ(wend({"bench", file, "--database", folder_ / "none/x.db"}).code, 2);
}

TEST_F(BenchDatabaseCommand, LeavesNothingBehindWhenItIsRefused) {
  const std::string file = scenario(kRight);
  scenario("version\n", "bad.scen");
  folder_.write("rough.txt", ".2\n..\n");
  folder_.write("rough.scen", "version 1\n0 rough.txt 2 2 0 0 1 0 1.5\n");
  const std::vector<std::vector<std::string>> refused{
      {file, "--planner", "astr"},
      {file, "--planner", "astar:weight=x"},
      {file, "--planner", "hub_labels:weight=2"},
      {file, "--threads", "0"},
      {file, "--index", folder_ / "none.idx"},
      {folder_ / "none.scen"},
      {folder_ / "bad.scen"},
      {file, folder_ / "rough.scen", "--planner", "jps"},
      {file, "--plot", folder_ / "plot.txt"}};
  for (std::vector<std::string> words : refused) {
    words.insert(words.begin(), "bench");
    words.insert(words.end(), {"--database", database_});
    const Outcome outcome = wend(words);
    EXPECT_EQ(outcome.code, 2) << outcome.err << outcome.out;
    EXPECT_FALSE(std::filesystem::exists(database_)) << outcome.err;
    std::filesystem::remove(database_);
  }
}

/// A run that is longer than any test waits for, on a map of its own, and can be stopped.
class LongBench : public BenchDatabaseCommand {
 protected:
  void SetUp() override {
    wend({"generate", "random", "--size", "200x200", "--seed", "3", "-o", folder_ / "long.map"});
    std::string queries = "version 1\n";
    for (int x = 0; x < kQueries; ++x) queries += "0 long.map 200 200 0 0 199 199 1\n";
    file_ = folder_.write("long.map.scen", queries);
  }

  /// Runs until an answer is stored, then sends a signal. What it wrote to standard error.
  std::string stop_with(int signal) const {
    const std::string err = folder_ / "err";
    std::vector<std::string> words{program(),   "bench",      file_,
                                   "--planner", "dijkstra",   "--repetitions",
                                   "1000000",   "--database", database_};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT,
                                     0600);
    pid_t child = 0;
    EXPECT_EQ(posix_spawn(&child, words[0].c_str(), &actions, nullptr, pointers_to(words).data(),
                          environ),
              0);
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    while (number_in(database_, "SELECT count(*) FROM runs") <= 0) {
      if (waitpid(child, &status, WNOHANG) != 0) ADD_FAILURE() << "it ended: " << bytes_of(err);
      std::this_thread::yield();
    }
    kill(child, signal);
    waitpid(child, &status, 0);
    if (signal == SIGINT) {
      EXPECT_EQ(WEXITSTATUS(status), 130);
    }
    return bytes_of(err);
  }

  static constexpr int kQueries = 40;
  std::string file_;
};

TEST_F(LongBench, LosesNothingThatWasStoredWhenItIsKilled) {
  stop_with(SIGKILL);
  const int runs = number_in(database_, "SELECT count(*) FROM runs");
  const int passes = number_in(database_, "SELECT count(*) FROM passes");
  EXPECT_GT(runs, 0);
  const Outcome resumed = wend({"bench", file_, "--planner", "dijkstra", "--database", database_});
  EXPECT_THAT(resumed.err, HasSubstr(std::to_string(runs) + " of " + std::to_string(kQueries) +
                                     " answers were already stored"));
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM runs"), kQueries);
  EXPECT_EQ(number_in(database_, "SELECT count(*) FROM passes"), passes + kQueries - runs);
}

TEST_F(LongBench, GoesOnAfterCtrlC) {
  EXPECT_THAT(stop_with(SIGINT), HasSubstr("run the same command again to continue"));
  const int runs = number_in(database_, "SELECT count(*) FROM runs");
  const Outcome resumed = wend({"bench", file_, "--planner", "dijkstra", "--database", database_});
  EXPECT_THAT(resumed.err, HasSubstr(std::to_string(runs) + " of " + std::to_string(kQueries) +
                                     " answers were already stored"));
}

}  // namespace
}  // namespace wend::test
