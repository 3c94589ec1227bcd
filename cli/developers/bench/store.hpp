#pragma once

// BenchStore: where `wend bench` keeps answers while it runs, so that an interrupted run can continue.
// Without --database: nowhere. The file is created when the first answer is kept, so a rejected
// command leaves none behind.

#include <optional>
#include <span>
#include <string>

#include "bench/database/bench_database.hpp"
#include "cli/developers/bench/scenarios.hpp"
#include "cli/developers/bench/settings.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

class BenchStore {
 public:
  /// Keeps nothing.
  BenchStore() = default;

  /// This and all functions below throw InputError if the file cannot be used.
  explicit BenchStore(const std::string& file);

  /// The same for a rank among many: what is known comes from the file, what is new goes to a shard.
  BenchStore(const std::string& file, const std::string& shard);

  /// From now on, answers belong to this scenario.
  void begin(const BenchScenario& scenario, const FreeSpace& space, const BenchSettings& settings);

  /// What is known of an entry on the scenario.
  BenchRecord known(const std::string& entry);

  void keep(const std::string& entry, std::span<const BenchAnswer> answers,
            const BenchIndex& index);

 private:
  BenchDatabase& written();

  std::string file_;                    // where new answers go; empty: nowhere
  std::optional<BenchDatabase> known_;  // none until the file exists
  std::optional<BenchDatabase> shard_;  // the same
  bool is_shard_ = false;               // do new answers go to the shard?
  BenchExperiment experiment_;
};

/// A shard is the database that one rank of `wend bench --distributed` fills, beside the common one: no
/// rank waits for another, and the finished work of a rank survives it.
std::string shard_file(const std::string& database, int rank);

/// Adds all shards that lie beside a database to it, and removes them. Throws InputError if one
/// cannot be read: then it stays.
void merge_shards(const std::string& database);

}  // namespace wend::cli
