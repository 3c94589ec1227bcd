#pragma once

// The C interface with any bytes at all as sizes, numbers, cells, corners and planners. Whatever they are, a
// function succeeds with a sound object, or fails with a status, a sentence and no object.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "checks.hpp"
#include "fuzzed_bytes.hpp"
#include "tests/testing/c_objects.hpp"
#include "wend/wend.h"

namespace wend::test {

inline wend_pose pose_from(FuzzedBytes& bytes) {
  return {bytes.number(), bytes.number(), bytes.number()};
}

/// What is wrong with how a call ended; empty if nothing is.
inline std::string check_end(wend_status status, const void* object, const wend_error& error) {
  if (status != error.status) return "the error has another status";
  if (std::memchr(error.message, '\0', sizeof error.message) == nullptr)
    return "an endless message";
  if ((object != nullptr) != (status == WEND_OK)) return "an object and an error, or neither";
  if (status == WEND_INTERNAL_ERROR) return std::string("an exception: ") + error.message;
  if (status == WEND_OK) return error.message[0] == '\0' ? "" : "a message without an error";
  if (std::string_view(wend_status_name(status)) == "unknown") return "an unknown status";
  return check_text(error.message);
}

/// Calls make(Object**, wend_error*). `wrong` gets what is wrong, if something is.
template <class Object, class Make>
Owned<Object> fuzzed_object(std::string& wrong, const Make& make) {
  auto* object = reinterpret_cast<Object*>(1);  // must become null
  wend_error error;
  const wend_status status = make(&object, &error);
  if (wrong.empty()) wrong = check_end(status, object, error);
  return Owned<Object>(object);
}

/// A map from the bytes of a file, or from cells.
inline Owned<wend_map> fuzzed_map(FuzzedBytes& bytes, std::string& wrong) {
  constexpr std::array<const char*, 4> kNames{"m", "m.map", "m.txt", "m.png"};
  const std::uint8_t kind = bytes.byte();
  if (kind >= 240) {
    return fuzzed_object<wend_map>(wrong, [&](wend_map** out, wend_error* error) {
      const std::string_view file = bytes.rest();
      return wend_map_parse(file.data(), file.size(), kNames[kind % kNames.size()], out, error);
    });
  }
  wend_map_options options;
  wend_map_options_init(&options, sizeof options);
  options.cells = bytes.byte() % 5 - 1;
  options.occupied_from = bytes.byte();
  options.resolution = bytes.number();
  options.origin = pose_from(bytes);
  const std::int32_t width = bytes.byte() % 24 - 1;
  const std::int32_t height = bytes.byte() % 24 - 1;
  // Usually as many cells as there should be.
  const int area = std::max(width, 0) * std::max(height, 0);
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(kind < 230 ? area : kind));
  for (std::uint8_t& cell : cells) cell = bytes.byte();
  if (kind % 8 == 5) {
    const double factor = bytes.number();
    return fuzzed_object<wend_map>(wrong, [&](wend_map** out, wend_error* error) {
      return wend_map_from_costmap(cells.data(), cells.size(), width, height, options.resolution,
                                   &options.origin, factor, out, error);
    });
  }
  std::vector<double> terrain;
  if (kind % 4 == 0) {
    for (std::size_t i = kind % 8; i < cells.size() + kind % 8; ++i) {
      terrain.push_back(1 + bytes.number());
    }
    options.terrain = terrain.data();
    options.terrain_count = terrain.size();
  }
  return fuzzed_object<wend_map>(wrong, [&](wend_map** out, wend_error* error) {
    return wend_map_create(cells.data(), cells.size(), width, height, &options, out, error);
  });
}

inline Owned<wend_robot> fuzzed_robot(FuzzedBytes& bytes, std::string& wrong) {
  wend_robot_options options;
  wend_robot_options_init(&options, sizeof options);
  std::vector<wend_point> corners(bytes.byte() % 8);
  for (wend_point& corner : corners) corner = {bytes.number() - 5, bytes.number() - 5};
  options.corners = corners.data();
  options.corner_count = corners.size();
  if (corners.empty() || bytes.byte() > 250) options.radius = bytes.number() - 1;
  options.clearance_distance = bytes.number();
  options.clearance_cost = bytes.number();
  return fuzzed_object<wend_robot>(wrong, [&](wend_robot** out, wend_error* error) {
    return wend_robot_create(&options, out, error);
  });
}

/// A plan is a path with a cost.
inline std::string check_plan(const wend_plan* plan) {
  if (plan == nullptr) return {};
  if (wend_plan_pose_count(plan) == 0 || wend_plan_poses(plan) == nullptr) return "an empty path";
  if (!(wend_plan_cost(plan) >= 0)) return "a path without a cost";
  if (!(wend_plan_bound(plan) >= 1)) return "a path that is better than the best";
  for (std::size_t i = 0; i < wend_metric_count(); ++i) {
    double value = -1;
    const wend_status status = wend_plan_metric(plan, wend_metric_name(i), &value, nullptr);
    if (status != WEND_OK || !(value >= 0)) return "a metric that cannot be";
  }
  return {};
}

inline std::string check_field(const wend_field* field, const wend_pose& start) {
  if (field == nullptr) return {};
  const int count = wend_field_width(field) * wend_field_height(field);
  for (int i = 0; i < count; ++i) {
    if (!(wend_field_costs(field)[i] >= 0)) return "a cost that is not a number from 0";
  }
  std::string wrong;
  const auto plan = fuzzed_object<wend_plan>(wrong, [&](wend_plan** out, wend_error* error) {
    return wend_field_plan(field, &start, out, error);
  });
  if (wrong.empty()) wrong = check_plan(plan.get());
  if (plan && std::isinf(wend_field_cost_at(field, start.x, start.y))) return "a path from nowhere";
  return wrong;
}

inline std::string check_questions(wend_session* session, const wend_pose& pose) {
  wend_error error;
  std::int32_t fits = -1;
  wend_status status = wend_session_fits(session, &pose, &fits, &error);
  std::string wrong = check_end(status, status == WEND_OK ? &fits : nullptr, error);
  if (!wrong.empty()) return wrong;
  if (status == WEND_OK && fits != 0 && fits != 1) return "neither fits nor does not";
  wend_pose nearest{};
  status = wend_session_nearest(session, &pose, &nearest, &error);
  return check_end(status, status == WEND_OK ? &nearest : nullptr, error);
}

/// A planner that ends with NUL, goals, a start, and how the path is refined.
class FuzzedRequest {
 public:
  explicit FuzzedRequest(FuzzedBytes& bytes) : planner_(bytes.text()), goals_(bytes.byte() % 4) {
    for (wend_pose& goal : goals_) goal = pose_from(bytes);
    wend_request_init(&request, sizeof request);
    request.start = pose_from(bytes);
    request.goals = goals_.data();
    request.goal_count = goals_.size();
    if (!planner_.empty()) request.planner = planner_.c_str();
    if (bytes.byte() < 64) request.tolerance = bytes.number();
    if (bytes.byte() < 64) request.heading_tolerance = bytes.number();
    request.expansions = 2000;
    request.straighten = bytes.byte() % 2;
    request.explain = bytes.byte() % 2;
    // As many poses as a path may have take long.
    if (bytes.byte() < 64) request.spacing = std::max(bytes.number(), 0.01);
    set_fields(bytes);
  }
  FuzzedRequest(const FuzzedRequest&) = delete;
  FuzzedRequest& operator=(const FuzzedRequest&) = delete;

  wend_request request{};
  std::string wrong{};  // with a call that set a field

 private:
  /// Sets fields by any names to any numbers, but for limits that would let a search take long.
  void set_fields(FuzzedBytes& bytes) {
    for (int i = bytes.byte() % 4; i > 0; --i) {
      wend_field_info info{"", "", "", 0, 0, 0, 0};
      wend_request_field_at(bytes.byte() % 32, &info);
      const std::string name = bytes.byte() < 16 ? bytes.text() : info.name;
      if (name == "expansions" || name == "spacing") continue;
      wend_error error{};
      const double value = bytes.byte() < 128 ? bytes.byte() % 2 : bytes.number();
      const wend_status status = wend_request_set(&request, name.c_str(), value, &error);
      wrong = check_end(status, status == WEND_OK ? &request : nullptr, error);
      if (!wrong.empty()) return;
    }
  }

  std::string planner_;
  std::vector<wend_pose> goals_;
};

/// What the paths of an anytime planner have shown.
struct FuzzedSolutions {
  std::string wrong;
  double cost = std::numeric_limits<double>::infinity();  // of the last one
};

inline int32_t take_solution(const wend_plan* plan, void* context) {
  FuzzedSolutions& solutions = *static_cast<FuzzedSolutions*>(context);
  if (solutions.wrong.empty()) solutions.wrong = check_plan(plan);
  if (wend_plan_cost(plan) > solutions.cost) solutions.wrong = "a dearer path after a cheaper one";
  solutions.cost = wend_plan_cost(plan);
  return 0;
}

inline std::string check_answers(wend_session* session, wend_request request) {
  std::string wrong = check_questions(session, request.start);
  FuzzedSolutions solutions;
  request.on_solution = take_solution;
  request.context = &solutions;
  const auto plan = fuzzed_object<wend_plan>(wrong, [&](wend_plan** out, wend_error* error) {
    return wend_session_plan(session, &request, out, error);
  });
  if (wrong.empty()) wrong = solutions.wrong;
  if (wrong.empty()) wrong = check_plan(plan.get());
  const auto field = fuzzed_object<wend_field>(wrong, [&](wend_field** out, wend_error* error) {
    return wend_session_field(session, &request, out, error);
  });
  return wrong.empty() ? check_field(field.get(), request.start) : wrong;
}

/// A robot, policies, a request and a map. Large maps are not planned on: indexes of them would take long.
inline std::string fuzz_c_interface(std::string_view any) {
  FuzzedBytes bytes(any);
  std::string wrong;
  const auto robot = fuzzed_robot(bytes, wrong);
  wend_session_options options;
  wend_session_options_init(&options, sizeof options);
  options.unknown = bytes.byte() % 4;
  options.outside = bytes.byte() % 3;
  const FuzzedRequest request(bytes);
  const auto map = fuzzed_map(bytes, wrong);
  const auto session =
      fuzzed_object<wend_session>(wrong, [&](wend_session** out, wend_error* error) {
        return wend_session_create(map.get(), robot.get(), &options, out, error);
      });
  constexpr int kLargest = 1 << 10;
  if (wrong.empty()) wrong = request.wrong;
  if (!wrong.empty() || !session) return wrong;
  if (wend_map_width(map.get()) > kLargest / wend_map_height(map.get())) return wrong;
  return check_answers(session.get(), request.request);
}

}  // namespace wend::test
