// SPDX-License-Identifier: Apache-2.0
#include "path_check.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "../src/conversions.hpp"
#include "../src/pose_messages.hpp"
#include "wend/control/given_route.hpp"
#include "wend/geometry/angle.hpp"
#include "wend_nav2/robot_shape.hpp"

namespace wend_nav2::trials {
PathCheck::PathCheck(nav2_costmap_2d::Costmap2DROS& costmap) {
  const auto footprint = footprint_from(costmap.getRobotFootprint());
  if (!footprint) throw std::runtime_error(footprint.error().message);
  const RobotShape shape{*footprint, true};
  round_ = footprint->outline() == nullptr;
  const bool is_point = shape.footprint.outline() == nullptr && shape.inflated;
  const ObstacleRule rule = is_point ? ObstacleRule::inscribed : ObstacleRule::footprint;
  const auto& costs = *costmap.getCostmap();
  const CostmapLayout layout{.width = static_cast<int>(costs.getSizeInCellsX()),
                             .height = static_cast<int>(costs.getSizeInCellsY()),
                             .resolution = costs.getResolution(),
                             .origin = {costs.getOriginX(), costs.getOriginY()},
                             .frame_id = "map"};
  const auto map = wend::map_from_costmap({costs.getCharMap(), layout.size()}, layout.width,
                                          layout.height, layout.frame(), scale_for(rule, 0));
  if (!map) throw std::runtime_error(map.error().message);
  auto space = wend::make_free_space(*map, robot_for(rule, shape, true));
  if (!space) throw std::runtime_error(space.error().message);
  space_ = *std::move(space);
}

bool PathCheck::fits(const wend::MapPose& pose) const {
  return space_->fits(space_->map().frame().to_grid(pose));
}

bool PathCheck::is_free(const nav_msgs::msg::Path& path) const {
  const auto taken = poses_from(path);
  if (!taken) throw std::runtime_error(taken.error());
  const std::vector<wend::MapPose>& poses = *taken;
  const bool headed = wend::headings_count(poses);
  const double half_cell = space_->map().frame().resolution / 2;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const wend::MapPose& a = poses[i];
    const wend::MapPose& b = poses[i + 1];
    const double way = distance(a.point(), b.point());
    const double along = std::atan2(b.y - a.y, b.x - a.x);
    const int steps = std::max(1, static_cast<int>(std::ceil(way / half_cell)));
    for (int n = 0; n < steps; ++n) {
      const double share = static_cast<double>(n) / steps;
      const double turned = a.heading + share * wend::normalized_angle(b.heading - a.heading);
      if (!fits({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), headed ? turned : along})) {
        return false;
      }
    }
  }
  return true;
}

wend::MapPose PathCheck::random_pose(std::mt19937& random) const {
  std::uniform_int_distribution<int> column(0, space_->width() - 1);
  std::uniform_int_distribution<int> row(0, space_->height() - 1);
  std::uniform_real_distribution<double> heading(-wend::kPi, wend::kPi);
  for (;;) {
    const wend::Point middle = wend::centre_of({column(random), row(random)});
    const wend::MapPoint point = space_->map().frame().to_metres(middle);
    const wend::MapPose pose{point.x, point.y, heading(random)};
    const bool known = space_->map().state({static_cast<int>(middle.x),
                                            static_cast<int>(middle.y)}) == wend::CellState::free;
    if (known && fits(pose)) return pose;
  }
}

}  // namespace wend_nav2::trials
