#pragma once

// What car_planner_client is told on its command line: ten numbers, a yard's file, or nothing.
//
//   car_planner_client
//   car_planner_client 20 20 0 0 2 18 18 2 25 25
//   car_planner_client yard:=yard.txt

#include <wend_ros/CarRequest.h>

#include <string>
#include <vector>

#include "wend/base/expected.hpp"

namespace wend_ros {

/// mapWidth mapHeight startX startY startD goalX goalY goalD obstacleCount roughRoadCount
inline constexpr std::size_t kCarArguments = 10;

/// The request for `words` (the program's arguments without its name and ROS's own); what is wrong
/// with them otherwise. Random yards are made from the seed so that no obstacle touches the start's
/// and the goal's corners.
wend::Expected<CarRequest, std::string> car_request(const std::vector<std::string>& words,
                                                    std::uint64_t seed);

}  // namespace wend_ros
