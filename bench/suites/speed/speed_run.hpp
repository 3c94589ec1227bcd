#pragma once

// Times planners beside Boost's A* on maps with scenarios, in one process and in turns, so that the
// ratio holds when the machine's speed drifts. Times are CPU time of the thread.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/suites/speed/speed_maps.hpp"
#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {

/// Means over the sampled queries of a map. First query: one run of a new planner, for a few of the
/// queries. Later queries: all, one after the other; the fastest of the runs that fill 5 ms counts, over
/// all rounds.
struct Timing {
  std::string name;
  double prepare_us = 0;  // to make a planner, with its index if it has one
  double first_us = 0;
  double later_us = 0;
  double fresh_us = 0;    // a planner made for each query, both counted, on one space; 0 for Boost
  double alone_us = 0;    // the same on a new space for each query, which is not counted
  double expanded = 0;    // a later query
  std::size_t wrong = 0;  // answers that disagree with the scenario
};

struct MapTimings {
  std::string map;
  std::size_t free_cells = 0;
  std::size_t queries = 0;
  double path_cells = 0;         // mean
  std::vector<Timing> planners;  // Boost's A* first
};

/// How many times as fast as Boost a planner is: the geometric mean over maps.
struct SpeedRatios {
  double later = 0;    // queries in a stream of many
  double first = 0;    // the first query of a new planner
  double prepare = 0;  // making the planner, with its index
};

struct SpeedPlan {
  std::vector<PlannerSpec> planners;
  std::size_t sample = 200;  // queries a map, evenly spread
  int rounds = 3;            // planner after planner
  bool fresh = false;        // time fresh planners, too
};

/// `progress(map, done, all)` is called before every map. An error says what is wrong with a planner's
/// name or options, or that it cannot plan on a map.
Expected<std::vector<MapTimings>, Error> run_speed(
    const std::vector<SpeedMap>& maps, const SpeedPlan& plan,
    const std::function<void(const std::string&, std::size_t, std::size_t)>& progress);

/// How many times as fast as Boost a planner is, by its place in MapTimings::planners.
SpeedRatios ratios_of(const std::vector<MapTimings>& maps, std::size_t planner);

/// The same for a time of the planner, Timing::fresh_us or alone_us, against later queries of Boost.
double fresh_ratio_of(const std::vector<MapTimings>& maps, std::size_t planner,
                      double Timing::* time);

}  // namespace wend::bench
