#pragma once

// BenchRow: how one planner did on the queries of one scenario.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bench/scenario/bench_answer.hpp"

namespace wend {

/// What all rows of a benchmark have in common.
struct BenchConditions {
  std::string version;  // of wend: "0.2.0"
  std::string commit;   // or "unknown"
  std::string machine;  // its processor and the compiler
  std::string robot;    // and its moves: "a point, 8 neighbours, no corner cutting"
  bool fresh = false;   // a new planner for every query
  double limit_s = 0;   // time limit of a query; 0: none
};

struct BenchRow {
  std::string scen{};
  std::string planner{};  // with its options: "astar:weight=2"
  unsigned threads = 1;   // that answered queries in parallel
  double build_s = 0;     // seconds to build its index; 0 without an index
  std::uint64_t index_bytes = 0;

  std::uint64_t queries = 0;
  std::uint64_t solved = 0;
  std::uint64_t timed_out = 0;
  std::uint64_t wrong = 0;
  std::uint64_t first_queries = 0;  // asked of new planners
  double prepare_us = 0;            // microseconds to make a planner, without its index; mean
  double first_us = 0;              // microseconds of its first query; mean
  double mean_us = 0;  // microseconds a query, solved or not, in its fastest repetition
  double median_us = 0;
  double p99_us = 0;  // 99 of 100 queries took no longer
  double expanded_per_query = 0;
  double expansions_per_second = 0;
  std::uint64_t passes = 0;    // repetitions that every query has
  double fastest_pass_us = 0;  // microseconds a query in the fastest repetition of all queries
  double slowest_pass_us = 0;

  /// Computes the statistics of the answers, which have at least one repetition; 0 without answers.
  void set_answers(std::span<const BenchAnswer> answers);

  /// How much slower the slowest repetition was than the fastest: 0.03 is 3 %.
  double spread() const;

  /// Milliseconds of preparation before the first query: index, if any, and planner.
  double prepare_ms() const { return 1e3 * build_s + 1e-3 * prepare_us; }
};

/// An object with the conditions and "rows": a list with one object per row, keyed by the names above.
/// One line with its line end.
std::string bench_json(const BenchConditions& conditions, std::span<const BenchRow> rows);

/// The same names and values, one line per row after a line of names. Quotes as in RFC 4180.
std::string bench_csv(const BenchConditions& conditions, std::span<const BenchRow> rows);

/// The same for people, in that many columns, 80 or more: the rows of a scenario below its name, without the folder
/// that all scenarios share. Shows the spread if there are several passes, and index sizes if there
/// are indexes.
std::string bench_table(const BenchConditions& conditions, std::span<const BenchRow> rows,
                        std::size_t width = 80);

}  // namespace wend
