#pragma once

// What the suite speed prints.

#include <string>
#include <vector>

#include "bench/suites/speed/speed_run.hpp"

namespace wend::bench {

/// A table a map and the geometric means, 80 columns wide.
std::string speed_text(const std::vector<MapTimings>& maps);

/// A row a map: a planner made for each query, beside later queries of Boost.
std::string fresh_text(const std::vector<MapTimings>& maps);

/// The same for programs.
std::string speed_json(const std::vector<MapTimings>& maps);

}  // namespace wend::bench
