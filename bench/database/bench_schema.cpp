#include "bench/database/bench_schema.hpp"

#include <fmt/format.h>

#include "wend/io/text.hpp"

namespace wend {
namespace {

constexpr std::int64_t kApplication = 0x77656E64;  // "wend"
constexpr std::int64_t kDatabaseSchema = 2;        // of this file
constexpr std::size_t kLongestFault = 200;         // of a damaged database, in bytes

// The columns up to `setup` are the twelve that Planner Arena knows. It treats later columns as
// parameters of a problem, and asks `progress` for a best cost.
constexpr const char* kTables = R"(
CREATE TABLE experiments (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  name VARCHAR(512),
  totaltime REAL,
  timelimit REAL,
  memorylimit REAL,
  runcount INTEGER,
  version VARCHAR(128),
  hostname VARCHAR(1024),
  cpuinfo TEXT,
  date DATETIME,
  seed VARCHAR(24),
  setup TEXT,
  map_width INTEGER,
  map_height INTEGER,
  free_cells INTEGER,
  threads INTEGER,
  scenario TEXT,
  fingerprint INTEGER,
  commit_hash TEXT,
  conditions TEXT
);
CREATE TABLE plannerConfigs (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  name VARCHAR(512) NOT NULL,
  settings TEXT
);
CREATE TABLE enums (
  name VARCHAR(512),
  value INTEGER,
  description TEXT,
  PRIMARY KEY (name, value)
);
CREATE TABLE runs (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  experimentid INTEGER,
  plannerid INTEGER,
  time REAL,
  solved BOOLEAN,
  status ENUM,
  solution_length REAL,
  correct_solution BOOLEAN,
  expanded INTEGER,
  build_s REAL,
  index_bytes INTEGER,
  prepare_s REAL,
  first_s REAL,
  line INTEGER,
  FOREIGN KEY (experimentid) REFERENCES experiments(id) ON DELETE CASCADE,
  FOREIGN KEY (plannerid) REFERENCES plannerConfigs(id) ON DELETE CASCADE
);
CREATE UNIQUE INDEX runsByLine ON runs (experimentid, plannerid, line);
CREATE TABLE passes (
  runid INTEGER,
  pass INTEGER,
  time REAL,
  PRIMARY KEY (runid, pass),
  FOREIGN KEY (runid) REFERENCES runs(id) ON DELETE CASCADE
);
CREATE TABLE progress (
  runid INTEGER,
  time REAL,
  best_cost REAL,
  PRIMARY KEY (runid, time),
  FOREIGN KEY (runid) REFERENCES runs(id) ON DELETE CASCADE
);
)";

// The same as OMPL's script with nested selections; our runs have no simplification time to add.
constexpr const char* kViews = R"(
CREATE VIEW bestPlannerConfigsPerExperiment AS
  WITH averages AS (
    SELECT plannerid, experimentid, plannerConfigs.name AS plannerName,
           avg(solved) AS avg_solved, avg(time) AS avg_total_time
    FROM runs
    JOIN plannerConfigs ON plannerConfigs.id = plannerid
    JOIN experiments ON experiments.id = experimentid
    GROUP BY plannerid, experimentid)
  SELECT plannerid, experimentid, min(avg_solved) AS avg_solved, avg_total_time
  FROM averages
  GROUP BY plannerName, experimentid
  ORDER BY avg_solved DESC, avg_total_time;
CREATE VIEW bestPlannerConfigs AS
  WITH averages AS (
    SELECT plannerid, plannerConfigs.name AS plannerName,
           avg(solved) AS avg_solved, avg(time) AS avg_total_time
    FROM runs
    JOIN plannerConfigs ON plannerConfigs.id = plannerid
    JOIN experiments ON experiments.id = experimentid
    GROUP BY plannerid)
  SELECT plannerid, min(avg_solved) AS avg_solved, avg_total_time
  FROM averages
  GROUP BY plannerName
  ORDER BY avg_solved DESC, avg_total_time;
)";

std::int64_t number_of(SqliteConnection& connection, const std::string& query) {
  SqliteStatement statement(connection, query);
  return statement.run() ? statement.integer(0) : 0;
}

void make_tables(SqliteConnection& connection) {
  SqliteTransaction transaction(connection);
  connection.run(kTables);
  connection.run(kViews);
  SqliteStatement add(connection, "INSERT INTO enums VALUES ('status', ?, ?)");
  for (int value = 0; value < kStatuses; ++value) {
    add.run(std::int64_t{value}, std::string(to_string(static_cast<Status>(value))));
  }
  connection.run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplication,
                             kDatabaseSchema));
  transaction.commit();
}

/// What is wrong with the existing tables.
std::string fault_of(SqliteConnection& connection) {
  if (number_of(connection, "PRAGMA application_id") != kApplication) {
    return "it is the database of something else, not of `wend bench`";
  }
  if (number_of(connection, "PRAGMA user_version") != kDatabaseSchema) {
    return "it was written by another version of wend; start a new file";
  }
  SqliteStatement check(connection, "PRAGMA quick_check(1)");
  const bool whole = check.run() && check.text(0) == "ok";
  if (connection.ok() && !whole)
    return "the database is damaged: " + text_line(check.text(0), kLongestFault);
  return {};
}

}  // namespace

std::string prepare_bench_schema(SqliteConnection& connection) {
  const bool is_new = number_of(connection, "SELECT count(*) FROM sqlite_schema") == 0;
  if (connection.ok() && is_new) make_tables(connection);
  std::string fault = connection.ok() ? fault_of(connection) : std::string();
  if (!fault.empty()) return fault;
  connection.run("PRAGMA foreign_keys = ON; PRAGMA synchronous = NORMAL");
  return connection.error();
}

}  // namespace wend
