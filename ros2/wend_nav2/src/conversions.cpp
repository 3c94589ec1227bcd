// SPDX-License-Identifier: Apache-2.0
#include "conversions.hpp"

#include <mutex>
#include <span>
#include <utility>

#include "wend_nav2/robot_shape.hpp"

namespace wend_nav2 {

wend::Expected<wend::Footprint, wend::Error> footprint_from(
    const std::vector<geometry_msgs::msg::Point>& corners) {
  std::vector<wend::MapPoint> points;
  for (const auto& corner : corners) points.push_back({corner.x, corner.y});
  return footprint_from(std::span<const wend::MapPoint>(points));
}

wend::Expected<RobotShape, wend::Error> robot_of(
    std::shared_ptr<nav2_costmap_2d::Costmap2DROS>& costmap) {
  auto footprint = footprint_from(costmap->getRobotFootprint());
  if (!footprint) {
    wend::Error error = std::move(footprint.error());
    error.message = "the costmap's footprint: " + error.message;
    return wend::Unexpected<wend::Error>(std::move(error));
  }
  const auto inflation = InflationLayer::getInflationLayer(costmap);
  const bool inflated = inflation && inflation->isEnabled() &&
                        inflation->getInflationRadius() >= footprint->inscribed_radius();
  return RobotShape{*footprint, inflated};
}

void read(nav2_costmap_2d::Costmap2D& costmap, const std::string& frame_id, CostmapCopy& copy) {
  const std::lock_guard lock(*costmap.getMutex());
  const CostmapLayout layout{.width = static_cast<int>(costmap.getSizeInCellsX()),
                             .height = static_cast<int>(costmap.getSizeInCellsY()),
                             .resolution = costmap.getResolution(),
                             .origin = {costmap.getOriginX(), costmap.getOriginY()},
                             .frame_id = frame_id};
  copy.read(layout, {costmap.getCharMap(), layout.size()});
}

}  // namespace wend_nav2
