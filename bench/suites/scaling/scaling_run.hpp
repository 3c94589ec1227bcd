#pragma once

// How planners scale with the map size, measured on generated maps.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"

namespace wend::bench {

/// A kind of map that is made in every size.
struct MapKind {
  std::string name;
  std::string generator;
  OptionValues options{};
};

struct ScalingPlan {
  std::vector<MapKind> kinds{};
  std::vector<int> sizes{};             // cells a side, ascending
  std::vector<std::string> planners{};  // "boost-astar" among them
  int largest_for_boost = 4096;
  double most_build_seconds = 60;  // an index that would take longer is left out
  double query_seconds = 2;        // per planner and map; after it no new query is asked
  double most_query_seconds = 1;   // a planner that needs more is left out on larger maps
  std::uint64_t queries = 100;     // at most
};

/// A planner on a map.
struct PlannerScale {
  double build_s = 0;  // of its index, on one core
  std::uint64_t index_bytes = 0;
  std::uint64_t memory_bytes = 0;  // all that it needs in addition to the map
  std::size_t queries = 0;
  double prepare_ms = 0;        // to make a planner, without its index
  double first_us = 0;          // the first query of a planner
  double later_us = 0;          // a query after those that were asked before
  double two_threads_gain = 0;  // speedup of two threads, in wall-clock time
  bool wrong = false;           // some path was longer or shorter than another planner's
};

struct MapScale {
  MapKind kind;
  int size = 0;
  std::uint64_t free_cells = 0;
  double space_s = 0;                                 // to make the FreeSpace of the map
  std::vector<std::optional<PlannerScale>> planners;  // in the plan's order; none: left out

  double cells() const { return static_cast<double>(size) * size; }
};

/// `progress` is told what comes next. Each planner is measured in a process of its own. An error says
/// what is wrong with the plan.
Expected<std::vector<MapScale>, Error> run_scaling(
    const ScalingPlan& plan, const std::function<void(const std::string&)>& progress);

/// All our planners that find a cheapest path by default, and Boost's A*.
std::vector<std::string> optimal_planners();

}  // namespace wend::bench
