#pragma once

// `wend bench` on scenarios whose map changes between their queries.

#include <string>
#include <vector>

#include "bench/scenario/bench_rows.hpp"
#include "cli/commands/bench/entry.hpp"
#include "cli/commands/bench/settings.hpp"
#include "wend/io/query/dynamic_scenario.hpp"

namespace wend::cli {

/// The scenarios of these files if they are dynamic ones, none if none is. Throws InputError if only some are, or
/// one cannot be read.
std::vector<DynamicScenario> load_dynamic_scenarios(const std::vector<std::string>& files);

/// The answers of an entry to all queries, in order, with one planner that is told of each change. The time of
/// a query includes that of telling the planner of the changes before it; editing the free space is not counted. Throws
/// InputError if the entry does not take its options or the changes, Cancelled after Ctrl-C.
BenchedMap run_dynamic(const DynamicScenario& scenario, const BenchEntry& entry,
                       const BenchSettings& settings);

}  // namespace wend::cli
