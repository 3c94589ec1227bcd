// `wend bench --distributed` under mpirun, on this machine.

#include <gmock/gmock.h>

#include <csignal>
#include <thread>

#include "tests/command_line/bench_folder.hpp"
#include "tests/command_line/database_number.hpp"
#include "tests/testing/build_paths.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// MPI keeps memory until the end, on purpose.
constexpr const char* kKeepsMemory = "ASAN_OPTIONS=detect_leaks=0";

class DistributedBench : public testing::Test, protected BenchFolder {
 protected:
  void SetUp() override {
    const Outcome alone = run_program(
        {program(), "bench", scenario(kRight), "--distributed", "--database", folder_ / "alone.db"},
        {kKeepsMemory});
    if (alone.err.find("built without it") != std::string::npos) GTEST_SKIP() << alone.err;
    EXPECT_EQ(alone.code, 0) << alone.err;
    if (shell("command -v mpirun").code != 0) GTEST_SKIP() << "there is no mpirun";
    wend({"generate", "random", "--size", "64x64", "--seed", "3", "-o", folder_ / "many.map"});
    std::string queries = "version 1\n";
    for (int x = 0; x < kQueries; ++x) queries += "0 many.map 64 64 0 0 63 63 100.81118318\n";
    file_ = folder_.write("many.map.scen", queries);
  }

  /// mpirun with `count` ranks, without a network. Each rank runs a line of sh in which $WEND is
  /// the program and $RANK its number.
  static std::vector<std::string> ranks(int count, const std::string& line) {
    return {"mpirun",
            "--allow-run-as-root",
            "--oversubscribe",
            "--mca",
            "btl",
            "self,vader,tcp",
            "--mca",
            "btl_tcp_if_include",
            "lo",
            "--mca",
            "oob_tcp_if_include",
            "lo",
            "-n",
            std::to_string(count),
            "env",
            kKeepsMemory,
            "WEND=" + program(),
            "sh",
            "-c",
            "RANK=$OMPI_COMM_WORLD_RANK; " + line};
  }

  std::string command(const std::string& more) const {
    return "exec \"$WEND\" bench '" + file_ + "' --planner astar,dijkstra --database '" +
           database_ + "' --distributed " + more;
  }

  int number(const std::string& query) const { return number_in(database_, query); }

  static constexpr int kQueries = 100;
  std::string file_;
  std::string database_ = folder_ / "all.db";
};

class RanksOfBench : public DistributedBench, public testing::WithParamInterface<int> {};

TEST_P(RanksOfBench, ShareTheQueriesAndMergeTheirAnswers) {
  const Outcome outcome = run_program(ranks(GetParam(), command("--repetitions 2 --format json")));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json rows = json::parse(outcome.out).at("rows");
  ASSERT_EQ(rows.size(), 2U);
  for (const json& row : rows) {
    EXPECT_EQ(row.at("queries"), kQueries);
    EXPECT_EQ(row.at("solved"), kQueries);
    EXPECT_EQ(row.at("passes"), 2);
  }
  EXPECT_EQ(number("SELECT count(*) FROM runs"), 2 * kQueries);
  EXPECT_EQ(number("SELECT count(*) FROM passes"), 4 * kQueries);
  EXPECT_EQ(number("SELECT count(*) FROM experiments"), 1);
  EXPECT_FALSE(std::filesystem::exists(database_ + ".rank0"));
  EXPECT_FALSE(std::filesystem::exists(database_ + ".rank1"));
  const Outcome alone = wend({"bench", file_, "--planner", "astar,dijkstra", "--repetitions", "2",
                              "--database", database_, "--format", "json"});
  EXPECT_EQ(json::parse(alone.out).at("rows"), rows);
}

INSTANTIATE_TEST_SUITE_P(Two, RanksOfBench, testing::Values(2));
INSTANTIATE_TEST_SUITE_P(Four, RanksOfBench, testing::Values(4));

TEST_F(DistributedBench, ARankThatDiesLosesNothingThatItFinished) {
  const std::string pids = folder_ / "pid";
  std::vector<std::string> words =
      ranks(2, "echo $$ > '" + pids + "'$RANK; " + command("--repetitions 1000000"));
  pid_t child = 0;
  ASSERT_EQ(
      posix_spawnp(&child, words[0].c_str(), nullptr, nullptr, pointers_to(words).data(), environ),
      0);
  int status = 0;
  const auto stored = [this](int rank) {
    return number_in(database_ + ".rank" + std::to_string(rank), "SELECT count(*) FROM runs");
  };
  while (stored(0) <= 0 || stored(1) <= 0) {
    ASSERT_EQ(waitpid(child, &status, WNOHANG), 0) << "mpirun ended";
    std::this_thread::yield();
  }
  kill(std::stoi(bytes_of(pids + "1")), SIGKILL);
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  const int finished = stored(0) + stored(1);
  const int times = number_in(database_ + ".rank0", "SELECT count(*) FROM passes") +
                    number_in(database_ + ".rank1", "SELECT count(*) FROM passes");
  EXPECT_GT(finished, 0);

  const Outcome resumed = run_program(ranks(4, command("--format json")));
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(json::parse(resumed.out).at("rows").at(1).at("queries"), kQueries);
  EXPECT_EQ(number("SELECT count(*) FROM runs"), 2 * kQueries);
  EXPECT_EQ(number("SELECT count(*) FROM passes"), times + 2 * kQueries - finished);
  EXPECT_EQ(stored(0), -1);
}

TEST_F(DistributedBench, NeedsADatabase) {
  const Outcome outcome = wend({"bench", file_, "--distributed"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--database"));
}

TEST_F(DistributedBench, EndsAllRanksIfOneCannotGoOn) {
  const std::string foreign = folder_.write("foreign.db", "a text\n");
  const Outcome outcome = run_program(
      ranks(2, "exec \"$WEND\" bench '" + file_ + "' --database '" + foreign + "' --distributed"));
  EXPECT_NE(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("file is not a database"));
  EXPECT_EQ(bytes_of(foreign), "a text\n");
}

}  // namespace
}  // namespace wend::test
