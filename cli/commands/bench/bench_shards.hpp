#pragma once

// Shards: databases beside the one that `wend bench --distributed` fills, one a rank. Each rank writes
// its own, so that none waits for another and what a rank has finished survives it.

#include <string>

namespace wend::cli {

std::string shard_file(const std::string& database, int rank);

/// Adds all shards that lie beside a database to it, and removes them. Throws InputError if one
/// cannot be read: then it stays.
void merge_shards(const std::string& database);

}  // namespace wend::cli
