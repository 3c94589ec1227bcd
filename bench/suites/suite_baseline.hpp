#pragma once

// What suites do with a baseline (measure/baseline.hpp): compare with it, or write it.

#include <cstddef>
#include <string>
#include <vector>

#include "bench/measure/baseline.hpp"

namespace wend::bench {

/// Prints both and how they differ; returns the exit code.
int compare_with(const Baseline& baseline, const std::vector<BaselineRow>& now);

/// Writes a file; throws Refused.
void save_baseline(const std::string& file, std::string times, std::size_t sample,
                   std::vector<BaselineRow> rows);

}  // namespace wend::bench
