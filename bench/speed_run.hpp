#pragma once

// Times planners beside Boost's A* on the scenarios of a folder, in one process and in turns, so
// that the ratio holds when the machine's speed drifts.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/planner/planner_spec.hpp"

namespace wend::bench {

/// Means over the sampled queries of a map. Every query is timed several times and its fastest run
/// counts. Who is fast answers the whole scenario before that, and its other queries between
/// the timed ones: what is measured is a stream of queries, warm, and none learned by heart.
struct Timing {
  std::string name;
  double mean_us = 0;
  double expanded = 0;    // a query
  std::size_t wrong = 0;  // answers that disagree with the scenario
};

struct MapTimings {
  std::string map;
  std::size_t free_cells = 0;
  std::size_t queries = 0;
  double path_cells = 0;  // mean
  Timing boost;
  std::vector<Timing> planners;

  double ratio(std::size_t planner) const { return boost.mean_us / planners[planner].mean_us; }
};

struct SpeedPlan {
  std::filesystem::path folder;  // of .map and .map.scen pairs
  std::vector<PlannerSpec> planners;
  std::size_t sample = 100;  // queries a map, evenly spread
  int rounds = 3;            // timed runs of every query
};

/// `progress(map, done, all)` is called before every map. An error says what is wrong with the
/// folder, a map, or a planner's name or options.
Expected<std::vector<MapTimings>, std::string> run_speed(
    const SpeedPlan& plan,
    const std::function<void(const std::string&, std::size_t, std::size_t)>& progress);

/// The geometric mean over the maps of Boost's mean time over the planner's.
double geometric_mean_ratio(const std::vector<MapTimings>& maps, std::size_t planner);

}  // namespace wend::bench
