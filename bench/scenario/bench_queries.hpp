#pragma once

// Per-query results of a benchmark, for programs.

#include <span>
#include <string>
#include <string_view>

#include "bench/scenario/bench_answer.hpp"

namespace wend {

/// The first line of bench_queries_csv(), with its line end.
extern const std::string_view kBenchQueriesHeader;

/// One line per answer, after a header line: scen, line (of the query in the scenario), planner, status,
/// length, expanded, wrong (0 or 1), prepare_us and first_us (empty where no new planner was asked),
/// later_us (of the fastest repetition; empty where every query had a new planner), passes. Quotes
/// as in RFC 4180. Times are microseconds.
std::string bench_queries_csv(std::span<const BenchedMap> maps, bool fresh);

}  // namespace wend
