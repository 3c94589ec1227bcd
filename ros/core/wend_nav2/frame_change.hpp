// SPDX-License-Identifier: Apache-2.0
#pragma once

// FrameChange: from the frame of a path to that of a costmap, known by where the robot is in both. Knows no ROS.
//
//   const FrameChange to_costmap(moment.on_path, moment.in_costmap);
//   const wend::MapPose there = to_costmap(path.back());

#include "wend/geometry/angle.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend_nav2 {

class FrameChange {
 public:
  /// From the frame in which the robot has the pose `here` to that in which it has the pose `there`; both finite.
  FrameChange(const wend::MapPose& here, const wend::MapPose& there)
      : here_(here), there_(there), turn_(wend::sine_and_cosine(there.heading - here.heading)) {}

  wend::MapPoint operator()(wend::MapPoint point) const {
    const double x = point.x - here_.x;
    const double y = point.y - here_.y;
    return {there_.x + turn_.cosine * x - turn_.sine * y,
            there_.y + turn_.sine * x + turn_.cosine * y};
  }

  wend::MapPose operator()(const wend::MapPose& pose) const {
    const wend::MapPoint at = (*this)(pose.point());
    return {at.x, at.y, wend::normalized_angle(pose.heading + there_.heading - here_.heading)};
  }

 private:
  wend::MapPose here_;
  wend::MapPose there_;
  wend::SineCosine turn_;
};

}  // namespace wend_nav2
