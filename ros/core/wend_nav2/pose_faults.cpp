// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/pose_faults.hpp"

#include <cmath>
#include <cstddef>

#include "wend/base/parse.hpp"
#include "wend/control/route.hpp"

namespace wend_nav2 {
namespace {

constexpr double kMostTurned = 1e6;  // rad: sine and cosine are exact to here

}  // namespace

std::string place_of(const wend::MapPose& pose) {
  const auto centimetres = [](double metres) {
    const bool rounds = std::abs(metres) <= wend::Route::kFarthest;
    return wend::format_number(rounds ? std::round(metres * 100) / 100 : metres);
  };
  return "(" + centimetres(pose.x) + ", " + centimetres(pose.y) + ")";
}

std::optional<std::string> fault_of(const wend::MapPose& pose) {
  if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.heading)) {
    return "contains NaN or infinity";
  }
  if (!wend::Route::can_hold(pose.point())) {
    return "is farther than " + wend::format_number(wend::Route::kFarthest) +
           " m from the origin of its frame";
  }
  if (std::abs(pose.heading) > kMostTurned) return "has a heading of more than 1e+06 rad";
  return std::nullopt;
}

std::optional<std::string> fault_of(std::span<const wend::MapPose> path) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (const auto fault = fault_of(path[i])) {
      return "pose " + std::to_string(i) + " of the path, " + place_of(path[i]) + ", " + *fault;
    }
  }
  return std::nullopt;
}

}  // namespace wend_nav2
