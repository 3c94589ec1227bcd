#pragma once

// Times planners on queries between poses, and holds every path to the independent check of
// conformance/driven_path.hpp. All times are CPU time of the thread.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "conformance/driven_path.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {

struct Se2Settings {
  double turning_radius = 0.4;  // m
  int rounds = 3;               // timed runs of every query; the fastest counts
  double seconds = 20;          // limit of a query; such a query is run once
  bool exhaustive = false;      // say of each unsolved query what an exhaustive search finds
};

/// One planner on the queries of one map and robot.
struct Se2Run {
  double making_ms = 0;       // the planner
  double first_query_ms = 0;  // the first answer of a new planner
  double resident_mb = 0;     // more memory in use after all queries than before making the planner
  std::vector<double> ms;     // of each query
  std::vector<double> expanded;
  std::uint64_t reached =
      0;  // poses of all searches; counted in runs of their own, for planners of continuous poses
  std::uint64_t by_curves = 0;               // of these, by curves of several motions
  std::vector<std::optional<double>> costs;  // m, of each query; nothing without a path
  double length = 0;                         // m, of all paths
  std::size_t gear_changes = 0;
  std::vector<std::string> unsolved;  // which query, and why
  std::vector<std::string> faults;    // of paths, by the check

  std::size_t solved() const { return ms.size() - unsolved.size(); }
};

/// The planner gets the turning radius of the settings, if it has such an option and its list does not set it.
/// Fails as making the planner does.
Expected<Se2Run, Error> se2_run(const FreeSpace& space, PlannerSpec spec,
                                const std::vector<Query>& queries, const Se2Settings& settings);

/// Milliseconds of Boost's A* on cells for each query, between the cells of its poses, for a disc that the robot
/// covers and without costs.
std::vector<double> boost_ms(const FreeSpace& space, const std::vector<Query>& queries, int rounds);

}  // namespace wend::bench
