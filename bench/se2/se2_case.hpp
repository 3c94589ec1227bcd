#pragma once

// What wend-se2 measures on: maps, the two robots, and random queries between poses.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::bench {

struct NamedMap {
  std::string name;
  GridMap map;
};

/// Loads a map; a line on stderr instead if that fails.
std::vector<NamedMap> loaded_maps(const std::vector<std::filesystem::path>& files);

/// A warehouse, an office, a car park for small robots, and small random clutter.
std::vector<NamedMap> generated_maps();

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
