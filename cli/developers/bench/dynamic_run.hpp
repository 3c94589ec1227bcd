#pragma once

// `wend bench` on scenarios whose map changes between their queries.

#include <string>
#include <vector>

#include "bench/scenario/bench_rows.hpp"
#include "cli/developers/bench/entry.hpp"
#include "cli/developers/bench/settings.hpp"
#include "wend/io/query/dynamic_scenario.hpp"

namespace wend::cli {

/// Loads these files if all of them are dynamic scenarios; returns nothing if none of them is. Throws InputError if
/// only some are dynamic, or if a file cannot be read.
std::vector<DynamicScenario> load_dynamic_scenarios(const std::vector<std::string>& files);

/// Runs all commands with one planner and returns its answers in order. The time of a query includes the update of
/// the planner after the changes before it, but not the edit of the free space. Throws InputError if the planner
/// rejects its options or the changes, and Cancelled after Ctrl-C.
BenchedMap run_dynamic(const DynamicScenario& scenario, const BenchEntry& entry,
                       const BenchSettings& settings);

}  // namespace wend::cli
