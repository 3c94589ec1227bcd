#pragma once

// BenchRow: how one planner did on the queries of one scenario.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace wend {

struct BenchRow {
  std::string scen;
  std::string planner;  // with its options: "astar:weight=2"
  std::uint64_t queries = 0;
  std::uint64_t solved = 0;
  std::uint64_t wrong = 0;
  double mean_us = 0;  // microseconds a query, solved or not
  double median_us = 0;
  double p99_us = 0;  // 99 of 100 queries took no longer
  double expanded_per_query = 0;
  double expansions_per_second = 0;

  /// Sets what follows from the time of every query and from all cells expanded; 0 without queries.
  void set_work(std::vector<double> microseconds, std::uint64_t expanded);
};

/// A list with an object a row, its keys the names above. One line with its line end.
std::string bench_json(std::span<const BenchRow> rows);

/// The same for people.
std::string bench_table(std::span<const BenchRow> rows);

}  // namespace wend
