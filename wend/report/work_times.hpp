#pragma once

// WorkTimes: what answering one query took from the map's file on, not the search alone.

#include <optional>

namespace wend {

/// CPU seconds of the thread (thread_time.hpp), of an index that of all threads that built it.
struct WorkTimes {
  double load = 0;                  // reading the map
  double free_space = 0;            // finding where the robot fits
  std::optional<double> planner{};  // making the planner, with all that it prepares for the map
  std::optional<double> index{};    // building an index, or opening one
  double search = 0;                // one run of the query

  double preparation() const { return load + free_space + planner.value_or(0) + index.value_or(0); }
};

}  // namespace wend
