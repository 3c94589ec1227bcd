#pragma once

// A database of benchmarks in which any values, rows, tables and bytes are others. It is refused in a sentence, or its
// answers are such as a benchmark gives: each has a known status and times from 0.

#include <sqlite3.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "bench/database/bench_database.hpp"
#include "checks.hpp"
#include "fuzzed_bytes.hpp"

namespace wend::test {

/// Two files of this process, in memory where there is such a folder.
class FuzzedDatabaseFiles {
 public:
  FuzzedDatabaseFiles() {
    const std::filesystem::path shared = "/dev/shm";
    const bool in_memory = access(shared.c_str(), W_OK) == 0;
    folder_ = (in_memory ? shared : std::filesystem::temp_directory_path()) /
              ("wend_fuzz_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~FuzzedDatabaseFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  FuzzedDatabaseFiles(const FuzzedDatabaseFiles&) = delete;
  FuzzedDatabaseFiles& operator=(const FuzzedDatabaseFiles&) = delete;

  std::filesystem::path fuzzed() const { return folder_ / "fuzzed.db"; }
  /// A name for a database that does not exist yet.
  std::filesystem::path fresh() const {
    const std::filesystem::path file = folder_ / "fresh.db";
    std::filesystem::remove(file);
    return file;
  }

 private:
  std::filesystem::path folder_;
};

/// The bytes of a sound database of one experiment and two planners.
inline std::string sound_database(const std::filesystem::path& file) {
  std::vector<BenchAnswer> answers;
  for (const std::size_t line : {1U, 2U, 5U}) {
    answers.push_back({.line = line, .length = 7.5, .expanded = 30, .seconds = {0.5, 0.25}});
  }
  answers[1].status = Status::unreachable;
  answers[1].first = FirstQuery{0.125, 0.5};
  answers[2].progress = {{0.125, 9}, {0.5, 7.5}};
  {
    auto database = *BenchDatabase::open(file);
    const auto experiment = database.experiment(
        {.map = "arena", .width = 9, .height = 9, .scenario = "arena.scen", .version = "1"});
    for (const char* planner : {"astar", "ara_star:weight=3"}) {
      if (!database.store(*experiment, *database.planner(planner), answers, {1.5, 64})) return {};
    }
  }
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Changes a database by SQL, as anybody can.
class FuzzedSql {
 public:
  explicit FuzzedSql(const std::filesystem::path& file) {
    sqlite3_open(file.c_str(), &database_);
    run("PRAGMA synchronous = OFF; PRAGMA journal_mode = OFF");
  }
  ~FuzzedSql() { sqlite3_close(database_); }
  FuzzedSql(const FuzzedSql&) = delete;
  FuzzedSql& operator=(const FuzzedSql&) = delete;

  void run(const std::string& statements) {
    sqlite3_exec(database_, statements.c_str(), nullptr, nullptr, nullptr);
  }

  /// Another value in a row.
  void set(FuzzedBytes& bytes) {
    constexpr std::array<std::string_view, 24> kColumns{
        "runs status",         "runs line",
        "runs time",           "runs solution_length",
        "runs expanded",       "runs correct_solution",
        "runs build_s",        "runs index_bytes",
        "runs prepare_s",      "runs first_s",
        "runs plannerid",      "runs solved",
        "passes time",         "passes pass",
        "passes runid",        "progress time",
        "progress best_cost",  "progress runid",
        "experiments name",    "experiments map_width",
        "experiments threads", "experiments timelimit",
        "plannerConfigs name", "enums value"};
    const std::string_view column = kColumns[bytes.byte() % kColumns.size()];
    const std::size_t gap = column.find(' ');
    const std::string text = "UPDATE " + std::string(column.substr(0, gap)) + " SET " +
                             std::string(column.substr(gap + 1)) +
                             " = ? WHERE rowid = " + std::to_string(1 + bytes.byte() % 12);
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(database_, text.c_str(), -1, &statement, nullptr) != SQLITE_OK) return;
    bind(statement, bytes);
    sqlite3_step(statement);
    sqlite3_finalize(statement);
  }

 private:
  static void bind(sqlite3_stmt* statement, FuzzedBytes& bytes) {
    const std::uint8_t kind = bytes.byte();
    if (kind < 100) {
      sqlite3_bind_int64(statement, 1, bytes.integer<std::int64_t>());
    } else if (kind < 190) {
      sqlite3_bind_double(statement, 1, bytes.number());
    } else if (kind < 200) {
      sqlite3_bind_null(statement, 1);
    } else {
      const std::string text = bytes.text();
      sqlite3_bind_text(statement, 1, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
    }
  }

  sqlite3* database_ = nullptr;
};

inline void change_by_sql(FuzzedSql& sql, FuzzedBytes& bytes) {
  constexpr std::array<const char*, 10> kChanges{
      "DELETE FROM passes WHERE rowid = 1",
      "DELETE FROM runs",
      "DELETE FROM experiments",
      "DROP TABLE progress",
      "DROP TABLE passes",
      "DROP VIEW bestPlannerConfigs",
      "ALTER TABLE runs RENAME COLUMN line TO row",
      "PRAGMA user_version = 1",
      "INSERT INTO passes VALUES (99, 1, 0.5)",
      "DROP INDEX runsByLine; INSERT INTO runs SELECT id + 50, experimentid, plannerid, time, "
      "solved, status, "
      "solution_length, correct_solution, expanded, build_s, index_bytes, prepare_s, first_s, line "
      "FROM runs"};
  const std::uint8_t kind = bytes.byte();
  if (kind % 4 == 0) return sql.run(kChanges[kind / 4 % kChanges.size()]);
  sql.set(bytes);
}

/// Changes a sound database, row by row and then byte by byte; or takes all bytes as they are.
inline void write_fuzzed_database(FuzzedBytes& bytes, const std::filesystem::path& file,
                                  const std::string& sound) {
  const std::uint8_t kind = bytes.byte();
  std::string content = kind == 255 ? std::string(bytes.rest()) : sound;
  const auto write = [&] { std::ofstream(file, std::ios::binary) << content; };
  write();
  if (kind == 255) return;
  {
    FuzzedSql sql(file);
    for (int i = 0; i < kind % 8; ++i) change_by_sql(sql, bytes);
  }
  if (kind % 8 != 0 || kind < 128) return;
  for (int i = 0; i < kind % 16; ++i) {
    content[bytes.any<std::uint16_t>() % content.size()] = static_cast<char>(bytes.byte());
  }
  if (kind > 240) content.resize(bytes.any<std::uint16_t>() % content.size());
  write();
}

inline std::string check_record(const BenchRecord& record) {
  for (const BenchAnswer& answer : record.answers) {
    const int status = static_cast<int>(answer.status);
    if (status < 0 || status > static_cast<int>(Status::index_mismatch)) return "an unknown status";
    if (answer.seconds.empty()) return "an answer without a time";
    for (const double seconds : answer.seconds) {
      if (!(seconds >= 0) || !std::isfinite(seconds)) return "an answer whose time is none";
    }
    if (!(answer.length >= 0) || !std::isfinite(answer.length)) return "a length that is none";
    if (answer.line > 1U << 31) return "an answer to a query that no file has";
    double before = 0;
    for (const BenchSolution& solution : answer.progress) {
      if (!(solution.seconds >= before) || !(solution.cost >= 0)) return "progress backwards";
      before = solution.seconds;
    }
  }
  return record.index.build_s >= 0 ? "" : "an index that was built in no time";
}

inline std::string fuzz_bench_database(std::string_view input) {
  static const FuzzedDatabaseFiles files;
  static const std::string sound = sound_database(files.fresh());
  FuzzedBytes bytes(input);
  const std::string file = files.fuzzed().string();
  write_fuzzed_database(bytes, file, sound);
  const auto database = BenchDatabase::open(file);
  if (!database) return check_error(database.error(), file);
  for (const std::int64_t planner : {1, 2}) {
    const auto record = database->record(1, planner);
    const std::string wrong = record ? check_record(*record) : check_error(record.error(), file);
    if (!wrong.empty()) return wrong;
    if (!record) return {};
  }
  auto other = BenchDatabase::open(files.fresh());
  const auto merged = other->merge(*database);
  return merged ? "" : check_text(merged.error().message);
}

}  // namespace wend::test
