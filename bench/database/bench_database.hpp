#pragma once

// BenchDatabase: the answers of benchmarks in a file, which is an SQLite database in the schema of
// OMPL's benchmarks, so that Planner Arena and OMPL's scripts read it:
//
//   experiments     a scenario on its map, under the same conditions
//   plannerConfigs  planners with their options
//   runs            a planner's answer to a query: `time` in seconds of CPU time (of its fastest
//                   pass), `solved`; `prepare_s` and `first_s` where a new planner was asked it first
//   enums           the words for `status` of a run
//   progress        of anytime planners: when each better path was there, and its cost
//   bestPlannerConfigsPerExperiment, bestPlannerConfigs
//                   views: how much planners solve and how fast, by name, as OMPL defines it
//
// Besides, `passes` has the seconds of every repetition of a run; our columns come after theirs.
// (M. Moll, I. Sucan and L. Kavraki, "Benchmarking Motion Planning Algorithms", 2015.)
//
// Stored answers are on the disk, even if the program crashes later. Storing an answer again replaces the
// older one. One thread; several programs may have the file open.
//
//   auto database = wend::BenchDatabase::open("bench.db");
//   if (!database) return report(database.error().message);
//   const auto experiment = database->experiment({.map = "arena", .version = "wend 0.1.0"});
//   const auto planner = database->planner("astar:weight=2");
//   if (!experiment || !planner) return report("bench.db cannot be written");
//   const auto stored = database->store(*experiment, *planner, answers);

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/scenario/bench_answer.hpp"
#include "wend/base/expected.hpp"
#include "wend/io/file_error.hpp"

namespace wend {

class SqliteConnection;

/// The key of an experiment: times of different experiments must not be mixed.
struct BenchExperiment {
  std::string map = {};  // its name: what Planner Arena calls the problem
  int width = 0;
  int height = 0;
  std::uint64_t free_cells = 0;
  std::string scenario = {};      // the name of its file
  std::uint64_t fingerprint = 0;  // of the map's cells and the scenario's queries
  unsigned threads = 1;
  std::string version = {};     // of the program: "wend 0.1.0"
  std::string commit = {};      // from which the program was built
  std::string conditions = {};  // the robot, its moves and what else changes times, in words
  double limit_s = 0;           // time limit of a query; 0: none
  std::string host = {};        // the machine's name
  std::string machine = {};     // its processor and the compiler

  friend bool operator==(const BenchExperiment&, const BenchExperiment&) = default;
};

/// What a planner needs in addition to the map.
struct BenchIndex {
  double build_s = 0;
  std::uint64_t bytes = 0;
};

/// A planner's answers in an experiment, by line.
struct BenchRecord {
  std::vector<BenchAnswer> answers;
  BenchIndex index;  // 0 without answers
};

class BenchDatabase {
 public:
  /// Creates the file if it is missing or empty. Fails, and writes nothing, if the file is not a
  /// database, is damaged, or is the database of something else. O(bytes).
  static Expected<BenchDatabase, Error> open(const std::filesystem::path& file);

  ~BenchDatabase();
  BenchDatabase(const BenchDatabase&) = delete;
  BenchDatabase& operator=(const BenchDatabase&) = delete;
  BenchDatabase(BenchDatabase&&) noexcept;
  BenchDatabase& operator=(BenchDatabase&&) noexcept;

  /// The number of an experiment, which is added if it does not exist; the host is not compared.
  Expected<std::int64_t, Error> experiment(const BenchExperiment& experiment);

  /// The number of a planner, typed with its options. A new planner is added.
  Expected<std::int64_t, Error> planner(std::string_view spec);

  /// The stored answers. Fails for values that no benchmark stores, such as an unknown status. O(answers).
  Expected<BenchRecord, Error> record(std::int64_t experiment, std::int64_t planner) const;

  /// Stores answers, each of which has a pass at least: all or, after an error, none.
  Expected<void, Error> store(std::int64_t experiment, std::int64_t planner,
                              std::span<const BenchAnswer> answers, const BenchIndex& index = {});

  /// Adds all answers of another database that this one lacks or has with fewer repetitions. A second
  /// merge changes nothing.
  Expected<void, Error> merge(const BenchDatabase& other);

 private:
  BenchDatabase(std::filesystem::path file, std::unique_ptr<SqliteConnection> connection);

  std::vector<std::pair<std::int64_t, BenchExperiment>> experiments() const;
  std::vector<std::pair<std::int64_t, std::string>> planners() const;
  Unexpected<Error> failure() const;
  bool ok() const;

  std::filesystem::path file_;
  std::unique_ptr<SqliteConnection> connection_;
};

}  // namespace wend
