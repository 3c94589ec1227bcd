#pragma once

// What the suite se2 measures on: maps, the two robots, and random queries between poses.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/suites/suite_maps.hpp"
#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::bench {

/// Those of files, and if `generated`, a warehouse, an office, a car park for small robots, rooms and small random
/// clutter; all in metres.
std::vector<NamedMap> se2_maps(const std::vector<std::filesystem::path>& files, bool generated);

struct NamedRobot {
  std::string name;
  FreeSpaceOptions options;
};

/// A disc of 0.22 m with a clearance cost, and a rectangle of 0.6 m x 0.4 m.
std::vector<NamedRobot> se2_robots();

/// Queries between poses at which the robot fits: at centres of cells, with random headings, in one connected
/// component of the cells in which it may fit. Not each of them has a path. The same seed gives the same
/// queries. Fewer if there are not so many such poses. O(cells + count).
std::vector<Query> random_pose_queries(const FreeSpace& space, std::uint64_t count,
                                       std::uint64_t seed);

}  // namespace wend::bench
