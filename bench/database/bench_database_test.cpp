#include "bench/database/bench_database.hpp"

#include <gmock/gmock.h>
#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace wend {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// All rows of a query, read with plain SQLite without our code; bars separate the fields.
std::vector<std::string> rows_of(const fs::path& file, const std::string& query) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READWRITE, nullptr), SQLITE_OK);
  std::vector<std::string> rows;
  const auto keep = [](void* out, int columns, char** fields, char** /*names*/) {
    std::string row;
    for (int i = 0; i < columns; ++i) {
      row += (i == 0 ? "" : "|") + std::string(fields[i] == nullptr ? "" : fields[i]);
    }
    static_cast<std::vector<std::string>*>(out)->push_back(row);
    return 0;
  };
  char* error = nullptr;
  sqlite3_exec(database, query.c_str(), keep, &rows, &error);
  EXPECT_EQ(error, nullptr) << error;
  sqlite3_close(database);
  return rows;
}

std::string bytes_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

const BenchExperiment kArena{.map = "arena",
                             .width = 49,
                             .height = 50,
                             .free_cells = 2054,
                             .scenario = "arena.map.scen",
                             .fingerprint = 0xFEDCBA9876543210,
                             .threads = 2,
                             .version = "wend 0.1.0",
                             .commit = "0123abc",
                             .conditions = "a point",
                             .limit_s = 1.5,
                             .host = "here",
                             .machine = "a processor"};

BenchAnswer answer(std::size_t line, std::vector<double> seconds) {
  return {.line = line, .length = 7.5, .expanded = 30, .seconds = std::move(seconds)};
}

class BenchDatabaseTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static BenchDatabase open(const fs::path& file) {
    auto database = BenchDatabase::open(file);
    EXPECT_TRUE(database) << database.error().message;
    return *std::move(database);
  }

  static std::string error_of(const fs::path& file) {
    const auto database = BenchDatabase::open(file);
    return database ? "" : database.error().message;
  }

  /// Fills a database with one experiment, one planner and these answers.
  static void fill(const fs::path& file, const std::string& planner,
                   const std::vector<BenchAnswer>& answers) {
    BenchDatabase database = open(file);
    EXPECT_TRUE(database.store(database.experiment(kArena).value(),
                               database.planner(planner).value(), answers, {1.5, 4096}));
  }

  static std::vector<BenchAnswer> answers_in(const fs::path& file, const std::string& planner) {
    BenchDatabase database = open(file);
    return database.record(database.experiment(kArena).value(), database.planner(planner).value())
        ->answers;
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("wend_database_" + std::to_string(getpid()));
  fs::path file_ = folder_ / "bench.db";
};

TEST_F(BenchDatabaseTest, KeepsWhenBetterPathsWereThere) {
  std::vector<BenchAnswer> answers{answer(3, {0.5}), answer(5, {0.25}), answer(8, {1})};
  answers[0].progress = {{0.125, 9}, {0.5, 7.5}};
  answers[2].progress = {{0.25, 12}, {0.25, 10}, {1, 7.5}};
  fill(file_, "ara_star", answers);
  EXPECT_THAT(rows_of(file_,
                      "SELECT line, progress.time, best_cost FROM progress JOIN runs ON runid = "
                      "runs.id ORDER BY line, progress.time"),
              ElementsAre("3|0.125|9.0", "3|0.5|7.5", "8|0.25|10.0", "8|1.0|7.5"));
  const std::vector<BenchAnswer> known = answers_in(file_, "ara_star");
  ASSERT_THAT(known, SizeIs(3));
  EXPECT_EQ(known[0].progress, answers[0].progress);
  EXPECT_THAT(known[1].progress, IsEmpty());
  EXPECT_THAT(known[2].progress, ElementsAre(BenchSolution{0.25, 10}, BenchSolution{1, 7.5}));
}

TEST_F(BenchDatabaseTest, ReplacesTheProgressOfAnAnswer) {
  BenchAnswer before = answer(3, {0.5});
  before.progress = {{0.125, 9}, {0.5, 7.5}};
  BenchAnswer after = answer(3, {0.5, 0.25});
  after.progress = {{0.25, 7.5}};
  fill(file_, "ara_star", {before});
  fill(file_, "ara_star", {after});
  EXPECT_THAT(rows_of(file_, "SELECT time, best_cost FROM progress"), ElementsAre("0.25|7.5"));
}

TEST_F(BenchDatabaseTest, HasTheTablesViewsAndColumnsOfOmpl) {
  open(file_);
  EXPECT_THAT(rows_of(file_,
                      "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT "
                      "LIKE 'sqlite_%' ORDER BY name"),
              ElementsAre("enums", "experiments", "passes", "plannerConfigs", "progress", "runs"));
  EXPECT_THAT(rows_of(file_, "SELECT name FROM sqlite_schema WHERE type = 'view' ORDER BY name"),
              ElementsAre("bestPlannerConfigs", "bestPlannerConfigsPerExperiment"));
  const auto columns = [this](const std::string& table) {
    return rows_of(file_, "SELECT name FROM pragma_table_info('" + table + "')");
  };
  std::vector<std::string> experiments = columns("experiments");
  experiments.resize(12);
  EXPECT_THAT(experiments,
              ElementsAre("id", "name", "totaltime", "timelimit", "memorylimit", "runcount",
                          "version", "hostname", "cpuinfo", "date", "seed", "setup"));
  EXPECT_THAT(columns("plannerConfigs"), ElementsAre("id", "name", "settings"));
  EXPECT_THAT(columns("enums"), ElementsAre("name", "value", "description"));
  EXPECT_THAT(columns("progress"), ElementsAre("runid", "time", "best_cost"));
  std::vector<std::string> runs = columns("runs");
  runs.resize(6);
  EXPECT_THAT(runs, ElementsAre("id", "experimentid", "plannerid", "time", "solved", "status"));
  EXPECT_THAT(columns("bestPlannerConfigs"),
              ElementsAre("plannerid", "avg_solved", "avg_total_time"));
  EXPECT_THAT(columns("bestPlannerConfigsPerExperiment"),
              ElementsAre("plannerid", "experimentid", "avg_solved", "avg_total_time"));
}

TEST_F(BenchDatabaseTest, ARunIsAQueryByAPlanner) {
  std::vector<BenchAnswer> answers{answer(2, {3e-6, 2e-6}), answer(4, {5e-6})};
  answers[1].status = Status::unreachable;
  answers[1].wrong = true;
  fill(file_, "astar:weight=2,heuristic=octile", answers);
  EXPECT_THAT(rows_of(file_,
                      "SELECT line, time, solved, description, solution_length, "
                      "correct_solution, expanded, build_s, index_bytes FROM runs JOIN enums "
                      "ON enums.name = 'status' AND value = status ORDER BY line"),
              ElementsAre("2|2.0e-06|1|found|7.5|1|30|1.5|4096",
                          "4|5.0e-06|0|unreachable|7.5|0|30|1.5|4096"));
  EXPECT_THAT(
      rows_of(file_, "SELECT name, settings FROM plannerConfigs"),
      ElementsAre("astar:weight=2,heuristic=octile|planner = astar\n;weight = 2\n;heuristic "
                  "= octile\n;"));
  EXPECT_THAT(rows_of(file_,
                      "SELECT name, totaltime, runcount, version, hostname, cpuinfo, "
                      "map_width, threads FROM experiments"),
              ElementsAre("arena|1.0e-05|2|wend 0.1.0|here|a processor|49|2"));
  EXPECT_THAT(rows_of(file_,
                      "SELECT round(avg_solved, 3), round(1e6 * avg_total_time, 3) FROM "
                      "bestPlannerConfigsPerExperiment"),
              ElementsAre("0.5|3.5"));
}

TEST_F(BenchDatabaseTest, ViewsOrderPlannersBySolvedAndTime) {
  fill(file_, "slow", {answer(2, {9e-6}), answer(3, {9e-6})});
  fill(file_, "quick", {answer(2, {1e-6}), answer(3, {1e-6})});
  std::vector<BenchAnswer> failed{answer(2, {1e-7})};
  failed[0].status = Status::step_limit;
  fill(file_, "bad", failed);
  for (const std::string view : {"bestPlannerConfigs", "bestPlannerConfigsPerExperiment"}) {
    EXPECT_THAT(rows_of(file_, "SELECT name FROM " + view +
                                   " JOIN plannerConfigs ON plannerConfigs.id = plannerid"),
                ElementsAre("quick", "slow", "bad"));
  }
}

TEST_F(BenchDatabaseTest, GivesBackWhatWasStored) {
  fill(file_, "astar", {answer(2, {3e-6, 2e-6}), answer(9, {5e-6})});
  fill(file_, "bfs", {answer(2, {1e-6})});
  fill(file_, "astar", {answer(2, {3e-6, 2e-6, 1e-6}), answer(4, {8e-6})});
  const std::vector<BenchAnswer> found = answers_in(file_, "astar");
  ASSERT_THAT(found, SizeIs(3));
  EXPECT_THAT(found[0].seconds, ElementsAre(3e-6, 2e-6, 1e-6));
  EXPECT_EQ(found[1].line, 4);
  EXPECT_EQ(found[2].line, 9);
  EXPECT_EQ(found[2].length, 7.5);
  EXPECT_EQ(found[2].expanded, 30);
  EXPECT_FALSE(found[2].wrong);
  EXPECT_THAT(rows_of(file_, "SELECT count(*) FROM passes"), ElementsAre("6"));
  BenchDatabase database = open(file_);
  const auto record =
      database.record(database.experiment(kArena).value(), database.planner("bfs").value());
  EXPECT_EQ(record->index.build_s, 1.5);
  EXPECT_EQ(record->index.bytes, 4096);
}

TEST_F(BenchDatabaseTest, OtherConditionsAreAnotherExperiment) {
  BenchDatabase database = open(file_);
  const std::int64_t arena = database.experiment(kArena).value();
  EXPECT_EQ(database.experiment(kArena).value(), arena);
  std::set<std::int64_t> others{arena};
  const auto add = [&](auto&& change) {
    BenchExperiment other = kArena;
    change(other);
    others.insert(database.experiment(other).value());
  };
  add([](BenchExperiment& other) { other.map = "den520d"; });
  add([](BenchExperiment& other) { other.scenario = "other.scen"; });
  add([](BenchExperiment& other) { other.fingerprint ^= 1; });
  add([](BenchExperiment& other) { other.threads = 1; });
  add([](BenchExperiment& other) { other.version = "wend 9"; });
  add([](BenchExperiment& other) { other.machine = "another"; });
  EXPECT_THAT(others, SizeIs(7));
}

TEST_F(BenchDatabaseTest, MergesWhatIsMissing) {
  const fs::path shard = folder_ / "shard.db";
  fill(file_, "astar", {answer(2, {1e-6, 2e-6}), answer(3, {1e-6})});
  fill(shard, "bfs", {answer(2, {7e-6})});
  fill(shard, "astar", {answer(2, {9e-6}), answer(3, {5e-6, 6e-6}), answer(5, {8e-6})});
  for (int round = 0; round < 2; ++round) {
    EXPECT_TRUE(open(file_).merge(open(shard)));
    const std::vector<BenchAnswer> merged = answers_in(file_, "astar");
    ASSERT_THAT(merged, SizeIs(3));
    EXPECT_THAT(merged[0].seconds, ElementsAre(1e-6, 2e-6));
    EXPECT_THAT(merged[1].seconds, ElementsAre(5e-6, 6e-6));
    EXPECT_THAT(merged[2].seconds, ElementsAre(8e-6));
    EXPECT_THAT(answers_in(file_, "bfs"), SizeIs(1));
    EXPECT_THAT(rows_of(file_, "SELECT hostname, fingerprint, free_cells FROM experiments"),
                ElementsAre("here|-81985529216486896|2054"));
  }
}

TEST_F(BenchDatabaseTest, LeavesForeignFilesAlone) {
  const std::string text = "a text that must not be lost\n";
  std::ofstream(file_) << text;
  EXPECT_THAT(error_of(file_), HasSubstr("bench.db: file is not a database"));
  EXPECT_EQ(bytes_of(file_), text);
  fs::remove(file_);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file_.c_str(), &database), SQLITE_OK);
  sqlite3_exec(database, "CREATE TABLE runs (id INTEGER)", nullptr, nullptr, nullptr);
  sqlite3_close(database);
  const std::string before = bytes_of(file_);
  EXPECT_THAT(error_of(file_), HasSubstr("the database of something else"));
  EXPECT_EQ(bytes_of(file_), before);
  EXPECT_THAT(error_of(folder_), HasSubstr("unable to open"));
  EXPECT_THAT(error_of(folder_ / "none" / "x.db"), HasSubstr("unable to open"));
}

TEST_F(BenchDatabaseTest, SaysThatAFileIsDamaged) {
  std::vector<BenchAnswer> many;
  for (std::size_t line = 0; line < 2000; ++line) many.push_back(answer(line, {1e-6}));
  fill(file_, "astar", many);
  const std::string whole = bytes_of(file_);
  std::string holed = whole;
  for (std::size_t i = whole.size() / 4; i < whole.size() / 2; ++i) holed[i] = 'x';
  for (const std::string& bytes : {holed, whole.substr(0, whole.size() / 2), whole.substr(0, 50)}) {
    std::ofstream(file_, std::ios::binary | std::ios::trunc) << bytes;
    EXPECT_NE(error_of(file_), "") << bytes.size();
    EXPECT_EQ(bytes_of(file_), bytes);
  }
}

TEST_F(BenchDatabaseTest, TakesAnEmptyFileForANewOne) {
  std::ofstream(file_).flush();
  EXPECT_EQ(error_of(file_), "");
}

TEST_F(BenchDatabaseTest, RefusesAnswersThatNoBenchmarkStores) {
  const auto error_after = [&](const std::string& change) {
    fill(file_, "astar", {answer(3, {0.5, 0.25}), answer(8, {1})});
    rows_of(file_, change);
    BenchDatabase database = open(file_);
    const auto record =
        database.record(database.experiment(kArena).value(), database.planner("astar").value());
    fs::remove(file_);
    return record ? "" : record.error().message;
  };
  EXPECT_EQ(error_after("SELECT 1"), "");
  for (const char* status : {"18", "-1", "4294967296", "1e300"}) {
    EXPECT_THAT(error_after(std::string("UPDATE runs SET status = ") + status),
                HasSubstr("the database is damaged: there is no status "));
  }
  EXPECT_THAT(error_after("UPDATE passes SET time = -1 WHERE rowid = 1"),
              HasSubstr("the answer to line 3: one of its times is negative or not finite"));
  EXPECT_THAT(error_after("UPDATE passes SET time = 9e999 WHERE rowid = 3"),
              HasSubstr("the answer to line 8: one of its times"));
  EXPECT_THAT(error_after("UPDATE runs SET solution_length = -9e999"), HasSubstr("its length"));
  EXPECT_THAT(error_after("UPDATE runs SET line = -1 WHERE id = 1"),
              HasSubstr("there is no such line"));
  EXPECT_THAT(error_after("UPDATE runs SET build_s = -1"), HasSubstr("build an index"));
}

}  // namespace
}  // namespace wend
