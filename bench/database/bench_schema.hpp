#pragma once

// The tables of a BenchDatabase. Only for the sources of this module.

#include <string>

#include "bench/database/sqlite.hpp"
#include "wend/base/status.hpp"

namespace wend {

/// The number of statuses, whose words are in `enums`.
inline constexpr int kStatuses = static_cast<int>(Status::index_mismatch) + 1;

/// Creates the tables of a new database, and checks an existing one. Returns what is wrong with it,
/// or empty; if something is wrong, nothing was written.
std::string prepare_bench_schema(SqliteConnection& connection);

/// Sets what an experiment (?1) says of all its runs.
inline constexpr const char* kSumUpExperiment =
    "UPDATE experiments SET "
    "totaltime = (SELECT total(passes.time) FROM passes INNER JOIN runs ON passes.runid = runs.id"
    " WHERE experimentid = ?1), "
    "runcount = (SELECT max(planned) FROM (SELECT count(*) AS planned FROM runs"
    " WHERE experimentid = ?1 GROUP BY plannerid)) WHERE id = ?1";

}  // namespace wend
