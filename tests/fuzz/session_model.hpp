#pragma once

// What a session of the C interface is told, as plain values: a map, a robot and policies, to which each call is
// applied by the words of wend.h. A new session of them has kept nothing from the calls before.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tests/testing/c_objects.hpp"
#include "wend/path/path.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/robot/footprint.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/wend.h"

namespace wend::test {

/// A box of cells, which may reach over the map's edge.
struct ModelBox {
  int x = 0;
  int y = 0;
  int width = 1;
  int height = 1;

  std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

struct ModelMap {
  int width = 1;
  int height = 1;
  double resolution = 1;  // a power of two: metres are exact
  int column = 0;         // where the first cell lies, in cells
  int row = 0;
  std::vector<std::uint8_t> states = {};  // as WEND_CELLS_STATE has them
  std::vector<double> terrain = {};       // one for each cell

  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  bool has(const ModelBox& box) const {
    return has(box.x, box.y) && has(box.x + box.width - 1, box.y + box.height - 1);
  }
  wend_pose origin() const { return {column * resolution, row * resolution, 0}; }

  /// Calls visit(index of the cell on the map, index in the box).
  template <class Visit>
  void each_of(const ModelBox& box, const Visit& visit) const {
    for (int i = 0; i < box.width * box.height; ++i) {
      visit(at(box.x + i % box.width, box.y + i / box.width), static_cast<std::size_t>(i));
    }
  }

  /// As wend_map_masked() does it. Does the mask touch the map?
  bool take_mask(const ModelMap& mask) {
    bool touches = false;
    for (int y = 0; y < mask.height; ++y) {
      for (int x = 0; x < mask.width; ++x) {
        const int here_x = x + mask.column - column;
        const int here_y = y + mask.row - row;
        if (!has(here_x, here_y)) continue;
        touches = true;
        const std::size_t here = at(here_x, here_y);
        const std::uint8_t state = mask.states[mask.at(x, y)];
        if (state == 1) states[here] = 1;
        if (state == 0) terrain[here] *= mask.terrain[mask.at(x, y)];
      }
    }
    return touches;
  }

  Owned<wend_map> made() const {
    wend_map_options options = map_options();
    options.resolution = resolution;
    options.origin = origin();
    options.terrain = terrain.data();
    options.terrain_count = terrain.size();
    return made_object<wend_map>([&](wend_map** out, wend_error* error) {
      return wend_map_create(states.data(), states.size(), width, height, &options, out, error);
    });
  }
};

struct ModelRobot {
  std::string footprint = "disc:0";
  double clearance_distance = 0;

  Owned<wend_robot> made() const {
    wend_robot_options options = robot_options();
    options.footprint = footprint.c_str();
    options.clearance_distance = clearance_distance;
    return made_object<wend_robot>([&](wend_robot** out, wend_error* error) {
      return wend_robot_create(&options, out, error);
    });
  }
};

struct SessionModel {
  ModelMap map;
  ModelRobot robot;
  wend_session_options policies = session_options();

  Owned<wend_session> made() const {
    const auto its_map = map.made();
    const auto its_robot = robot.made();
    return c_session(its_map.get(), its_robot.get(), &policies);
  }

  FreeSpace space() const {
    Grid<CellState> cells(map.width, map.height, CellState::free);
    for (int y = 0; y < map.height; ++y) {
      for (int x = 0; x < map.width; ++x) {
        cells[{x, y}] = static_cast<CellState>(map.states[map.at(x, y)]);
      }
    }
    const wend_pose origin = map.origin();
    FreeSpaceOptions options{.footprint = *parse_footprint(robot.footprint)};
    if (policies.unknown == WEND_POLICY_FREE) options.unknown = UnknownPolicy::free;
    if (policies.outside == WEND_POLICY_FREE) options.outside = OutsidePolicy::free;
    return *make_free_space(*make_grid_map(cells, {.resolution = map.resolution,
                                                   .origin = {origin.x, origin.y, 0},
                                                   .y_up = true,
                                                   .metric = true}),
                            options);
  }

  /// Does the robot stay free along a plan, joined by arcs if it has headings, by lines if not?
  bool is_free(const wend_plan* plan, bool headings) const {
    const FreeSpace here = space();
    std::vector<Pose> poses;
    std::vector<Point> points;
    for (const wend_pose& pose : std::span(wend_plan_poses(plan), wend_plan_pose_count(plan))) {
      poses.push_back(here.map().frame().to_grid(MapPose{pose.x, pose.y, pose.heading}));
      points.push_back(poses.back().point());
    }
    const Path path = headings ? Path::through(std::move(poses)) : Path::along(std::move(points));
    return !first_collision(path, here, Adjacency::edges_and_corners);
  }
};

}  // namespace wend::test
