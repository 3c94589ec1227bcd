#pragma once

// The cases of the suite `cases`: where planners are cold, maps noisy or costs graded. Maps are made from seeds.

#include <functional>
#include <string>
#include <vector>

namespace wend::bench {

/// One case; its inputs are made when it is made. `run` does it once, from the beginning, and returns the seconds of
/// what counts.
struct Case {
  std::string subject;  // a planner or a part
  std::string measure;  // of it
  std::function<double()> run;
};

/// All of them, in the order of the table.
std::vector<Case> all_cases();

/// The yardstick: Boost.Graph's A* on one of the maps.
Case boost_case();

}  // namespace wend::bench
