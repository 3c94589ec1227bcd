// SPDX-License-Identifier: Apache-2.0
//
// plan_trials: planners of Nav2 side by side, in one host. Which ones, and the costmap, are parameters, as those of a
// planner server (config/trials.yaml).
//
//   plan_trials compare MAP.yaml QUERIES --ros-args --params-file trials.yaml
//   plan_trials warm MAP.yaml CALLS --ros-args --params-file trials.yaml
//   plan_trials codes --ros-args --params-file trials.yaml
//
// compare: random queries, the same for all planners: how many were answered and how, times, lengths, and paths on
// which the robot touches an obstacle. warm: many calls on a costmap that changes between them, and the memory of the
// process. codes: the error codes of queries that must fail.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

#include "costmap_host.hpp"
#include "outcome.hpp"
#include "path_check.hpp"
#include "wend/io/map/load_map.hpp"

namespace wend_nav2::trials {
namespace {

struct Entrant {
  std::string name;
  nav2_core::GlobalPlanner::Ptr planner;
  std::vector<double> milliseconds;  // of the queries with a path
  std::map<std::string, int> codes;
  int collisions = 0;
  double length_ratio = 0;  // sum of the ratios to the first entrant's lengths
  int ratios = 0;
};

std::vector<Entrant> entrants_of(CostmapHost& host) {
  auto& node = host.node();
  const std::vector<std::string> names =
      node.declare_parameter("planner_plugins", std::vector<std::string>());
  std::vector<Entrant> entrants;
  for (const std::string& name : names) {
    const std::string type = node.declare_parameter(name + ".plugin", std::string());
    Entrant& entrant = entrants.emplace_back();
    entrant.name = name;
    entrant.planner = host.planner(name, type);
  }
  return entrants;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

wend::GridMap map_of(const std::string& file) {
  auto loaded = wend::load_map(file);
  if (!loaded) throw std::runtime_error(loaded.error().message);
  return loaded->map;
}

void ask(Entrant& entrant, const wend::MapPose& start, const wend::MapPose& goal,
         const PathCheck& check, double& length_of_first) {
  const Outcome outcome = call(*entrant.planner, start, goal);
  ++entrant.codes[outcome.code];
  if (outcome.code != "NONE") return;
  entrant.milliseconds.push_back(outcome.milliseconds);
  entrant.collisions += check.is_free(outcome.path) ? 0 : 1;
  const double length = length_of(outcome.path);
  if (length_of_first == 0) length_of_first = length;
  if (length_of_first > 0) {
    entrant.length_ratio += length / length_of_first;
    ++entrant.ratios;
  }
}

void print(const Entrant& entrant) {
  std::string codes;
  for (const auto& [code, count] : entrant.codes) codes += code + ' ' + std::to_string(count) + ' ';
  std::printf("| %s | %zu | %.2f | %.2f | %.2f | %.3f | %d | %s|\n", entrant.name.c_str(),
              entrant.milliseconds.size(), quantile(entrant.milliseconds, 0.5),
              quantile(entrant.milliseconds, 0.95), quantile(entrant.milliseconds, 1),
              entrant.ratios > 0 ? entrant.length_ratio / entrant.ratios : 0, entrant.collisions,
              codes.c_str());
}

void compare(const std::string& file, int queries) {
  CostmapHost host(map_of(file));
  const PathCheck check(host.costmap_ros());
  std::vector<Entrant> entrants = entrants_of(host);
  std::mt19937 random(1);
  int asked = 0;
  // A signal ends the trial with what there is.
  for (; asked < queries && rclcpp::ok(); ++asked) {
    const wend::MapPose start = check.random_pose(random);
    const wend::MapPose goal = check.random_pose(random);
    double length_of_first = 0;  // -1: the first has no path
    for (Entrant& entrant : entrants) {
      ask(entrant, start, goal, check, length_of_first);
      if (length_of_first == 0) length_of_first = -1;
    }
  }
  std::printf("%s: %u x %u cells, %s robot, %d queries\n", file.c_str(),
              host.costmap().getSizeInCellsX(), host.costmap().getSizeInCellsY(),
              check.round() ? "round" : "polygonal", asked);
  std::printf("| planner | paths | ms, median | 95 %% | max | length | collisions | codes |\n");
  for (const Entrant& entrant : entrants) print(entrant);
}

double resident_mebibytes() {
  std::ifstream file("/proc/self/statm");
  double pages = 0;
  file >> pages >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// A box of obstacles appears or disappears.
void change(nav2_costmap_2d::Costmap2D& costs, std::mt19937& random, bool appears) {
  const std::lock_guard lock(*costs.getMutex());
  static unsigned x = 0;
  static unsigned y = 0;
  static std::vector<unsigned char> before;
  if (appears) {
    x = random() % (costs.getSizeInCellsX() - 8);
    y = random() % (costs.getSizeInCellsY() - 8);
    before.clear();
  }
  for (unsigned i = 0; i < 64; ++i) {
    const unsigned column = x + i % 8;
    const unsigned row = y + i / 8;
    if (appears) before.push_back(costs.getCost(column, row));
    costs.setCost(column, row, appears ? 254 : before[i]);
  }
}

void warm(const std::string& file, int calls) {
  CostmapHost host(map_of(file));
  const PathCheck check(host.costmap_ros());
  for (Entrant& entrant : entrants_of(host)) {
    std::mt19937 random(2);
    double begin = 0;
    double milliseconds = 0;
    for (int n = 0; n < calls; ++n) {
      change(host.costmap(), random, n % 2 == 0);
      const Outcome outcome =
          call(*entrant.planner, check.random_pose(random), check.random_pose(random));
      ++entrant.codes[outcome.code];
      milliseconds += outcome.milliseconds;
      if (n == calls / 10) begin = resident_mebibytes();
    }
    std::string codes;
    for (const auto& [code, count] : entrant.codes)
      codes += code + ' ' + std::to_string(count) + ' ';
    std::printf("| %s | %d | %.2f | %.1f | %.1f | %s|\n", entrant.name.c_str(), calls,
                milliseconds / calls, begin, resident_mebibytes(), codes.c_str());
  }
}

/// Rooms of 0.05 m cells: a hall, a closed room with a place to stand, and a wall that is one cell thin and runs along
/// a diagonal, so that its cells only touch at corners.
wend::GridMap rooms() {
  wend::Grid<wend::CellState> cells(160, 80, wend::CellState::free);
  const auto wall = [&](int x, int y) { cells[{x, y}] = wend::CellState::occupied; };
  for (int i = 0; i <= 30; ++i) {
    wall(20 + i, 20);
    wall(20 + i, 50);
    wall(20, 20 + i);
    wall(50, 20 + i);
  }
  for (int i = 0; i < 80; ++i) wall(75 + i, i);
  return *wend::make_grid_map(cells, {.resolution = 0.05, .y_up = true, .metric = true});
}

void codes() {
  CostmapHost host(rooms());
  struct Case {
    std::string name;
    wend::MapPose start;
    wend::MapPose goal;
    bool cancelled = false;
  };
  const wend::MapPose hall{0.5, 0.5, 0};
  const wend::MapPose hall_too{3.2, 3.5, 0};
  const std::vector<Case> cases{{"a path", hall, hall_too},
                                {"start outside", {-1, -1, 0}, hall},
                                {"goal outside", hall, {30, 1, 0}},
                                {"start in a wall", {1.02, 1.5, 0}, hall},
                                {"goal in a wall", hall, {1.02, 1.5, 0}},
                                {"boxed-in start", {1.75, 1.75, 0}, hall},
                                {"goal in a closed room", hall, {1.75, 1.75, 0}},
                                {"goal behind a thin wall", hall, {7, 0.6, 0}},
                                {"cancelled", hall, hall_too, true}};
  std::vector<Entrant> entrants = entrants_of(host);
  for (const Case& each : cases) {
    for (Entrant& entrant : entrants) {
      const Outcome outcome =
          call(*entrant.planner, each.start, each.goal, [&] { return each.cancelled; });
      std::printf("| %s | %s | %s | %s |\n", each.name.c_str(), entrant.name.c_str(),
                  outcome.code.c_str(), outcome.message.c_str());
    }
  }
}

int run(const std::vector<std::string>& words) {
  const std::string command = words.size() > 1 ? words[1] : "";
  if (command == "compare" && words.size() == 4) {
    compare(words[2], std::stoi(words[3]));
  } else if (command == "warm" && words.size() == 4) {
    warm(words[2], std::stoi(words[3]));
  } else if (command == "codes" && words.size() == 2) {
    codes();
  } else {
    std::fprintf(stderr, "plan_trials compare|warm MAP.yaml COUNT, or plan_trials codes\n");
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace wend_nav2::trials

int main(int argc, char** argv) {
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const int status = wend_nav2::trials::run(words);
  rclcpp::shutdown();
  return status;
}
