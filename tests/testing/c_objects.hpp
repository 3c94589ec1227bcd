#pragma once

// Objects of the C interface that free themselves, and those that tests make again and again.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "wend/map/grid_map.hpp"
#include "wend/wend.h"

namespace wend::test {

/// Frees an object of the C interface.
struct FreeObject {
  void operator()(wend_map* map) const { wend_map_free(map); }
  void operator()(wend_robot* robot) const { wend_robot_free(robot); }
  void operator()(wend_session* session) const { wend_session_free(session); }
  void operator()(wend_plan* plan) const { wend_plan_free(plan); }
  void operator()(wend_field* field) const { wend_field_free(field); }
};

template <class Object>
using Owned = std::unique_ptr<Object, FreeObject>;

constexpr double kAnyHeading = std::numeric_limits<double>::quiet_NaN();

/// Calls make(Object**, wend_error*), which has to succeed.
template <class Object, class Make>
Owned<Object> made_object(Make&& make) {
  Object* object = nullptr;
  wend_error error;
  EXPECT_EQ(make(&object, &error), WEND_OK) << error.message;
  EXPECT_NE(object, nullptr);
  return Owned<Object>(object);
}

/// Structures with their defaults.
inline wend_map_options map_options() {
  wend_map_options options;
  EXPECT_EQ(wend_map_options_init(&options, sizeof options), WEND_OK);
  return options;
}
inline wend_robot_options robot_options() {
  wend_robot_options options;
  EXPECT_EQ(wend_robot_options_init(&options, sizeof options), WEND_OK);
  return options;
}
inline wend_session_options session_options() {
  wend_session_options options;
  EXPECT_EQ(wend_session_options_init(&options, sizeof options), WEND_OK);
  return options;
}

/// A request with one goal, which has to outlive it.
inline wend_request request_to(const wend_pose& goal, const wend_pose& start = {0.5, 0.5, 0}) {
  wend_request request;
  EXPECT_EQ(wend_request_init(&request, sizeof request), WEND_OK);
  request.start = start;
  request.goals = &goal;
  request.goal_count = 1;
  return request;
}

/// Bytes of WEND_CELLS_STATE.
inline std::vector<std::uint8_t> bytes_of(const GridMap& map) {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      bytes.push_back(static_cast<std::uint8_t>(map.state({x, y})));
    }
  }
  return bytes;
}

/// The same map through the C interface, whose maps are in metres with y up.
inline Owned<wend_map> c_map(const GridMap& map) {
  wend_map_options options = map_options();
  const Frame& frame = map.frame();
  options.resolution = frame.resolution;
  options.origin = {frame.origin.x, frame.origin.y, frame.origin.heading};
  if (!map.uniform_terrain()) {
    options.terrain = map.terrain().values().data();
    options.terrain_count = map.size();
  }
  const std::vector<std::uint8_t> bytes = bytes_of(map);
  return made_object<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_create(bytes.data(), bytes.size(), map.width(), map.height(), &options, out,
                           error);
  });
}

/// A map of this size without obstacles, of 1 m a cell.
inline Owned<wend_map> open_c_map(int width, int height) {
  return c_map(*make_grid_map(Grid<CellState>(width, height, CellState::free)));
}

inline Owned<wend_session> c_session(const wend_map* map, const wend_robot* robot = nullptr,
                                     const wend_session_options* options = nullptr) {
  return made_object<wend_session>([&](wend_session** out, wend_error* error) {
    return wend_session_create(map, robot, options, out, error);
  });
}

/// How a call that makes an object failed: its status and its message.
struct Refusal {
  wend_status status;
  std::string message;
};

/// Calls make(Object**, wend_error*), which has to fail, and to say the same in the error.
template <class Object, class Make>
Refusal refusal_of(Make&& make) {
  auto* object = reinterpret_cast<Object*>(1);  // must become null
  wend_error error;
  const wend_status status = make(&object, &error);
  EXPECT_EQ(object, nullptr);
  EXPECT_NE(status, WEND_OK);
  EXPECT_EQ(error.status, status);
  EXPECT_NE(error.message[0], '\0');
  EXPECT_EQ(make(&object, nullptr), status) << "without an error";
  return {status, error.message};
}

}  // namespace wend::test
