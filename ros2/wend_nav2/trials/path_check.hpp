// SPDX-License-Identifier: Apache-2.0
#pragma once

// PathCheck: does a robot that follows a published path touch an obstacle? Independent of the planners.

#include <optional>
#include <random>

#include <nav2_costmap_2d/costmap_2d_ros.hpp>
#include <nav_msgs/msg/path.hpp>

#include "wend/robot/free_space.hpp"

namespace wend_nav2::trials {

class PathCheck {
 public:
  /// On the costs as they are now, for the costmap's robot. A round one's centre may not be in cells of costs 253 and
  /// 254, which is what Nav2 itself checks; the footprint of another one may not overlap cells of cost 254.
  explicit PathCheck(nav2_costmap_2d::Costmap2DROS& costmap);

  bool round() const { return round_; }
  /// May the robot stand here?
  bool fits(const wend::MapPose& pose) const;
  /// At all poses, and between them, at most half a cell apart? Where a planner gives no headings, the robot faces
  /// along the way.
  bool is_free(const nav_msgs::msg::Path& path) const;

  /// A pose at which the robot fits.
  wend::MapPose random_pose(std::mt19937& random) const;

 private:
  bool round_;
  std::optional<wend::FreeSpace> space_;
};

}  // namespace wend_nav2::trials
