// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/robot_shape.hpp"

#include <utility>
#include <vector>

#include "wend/geometry/polygon.hpp"

namespace wend_nav2 {
namespace {

// Nav2 publishes a radius as a polygon of 16 corners, whose inscribed radius is 0.981 of it.
constexpr std::size_t kCornersOfCircle = 16;
constexpr double kRoundness = 0.975;

/// A circle that is written as a polygon becomes a disc.
wend::Footprint round_if_round(const wend::Footprint& footprint) {
  const wend::Polygon* const outline = footprint.outline();
  const double radius = footprint.circumscribed_radius();
  const bool round = outline != nullptr && outline->corners().size() >= kCornersOfCircle &&
                     footprint.inscribed_radius() >= kRoundness * radius;
  return round ? wend::Footprint::disc(radius) : footprint;
}

}  // namespace

wend::Expected<wend::Footprint, wend::Error> footprint_from(
    std::span<const wend::MapPoint> corners) {
  std::vector<wend::Point> outline;
  for (const wend::MapPoint& corner : corners) outline.push_back({corner.x, corner.y});
  auto polygon = wend::Polygon::make(std::move(outline));
  if (!polygon) return wend::Unexpected<wend::Error>(std::move(polygon.error()));
  auto footprint = wend::Footprint::polygon(*std::move(polygon));
  if (!footprint) return footprint;
  return round_if_round(*footprint);
}

wend::Expected<wend::Footprint, wend::Error> footprint_from(std::string_view text) {
  auto footprint = wend::parse_footprint(text);
  if (!footprint) return footprint;
  return round_if_round(*footprint);
}

ObstacleRule rule_for(ObstacleRule rule) {
  return rule == ObstacleRule::automatic ? ObstacleRule::footprint : rule;
}

wend::CostmapScale scale_for(ObstacleRule rule, double cost_factor) {
  return {.cost_factor = cost_factor, .inscribed_blocked = rule != ObstacleRule::footprint};
}

wend::FreeSpaceOptions robot_for(ObstacleRule rule, const RobotShape& robot, bool allow_unknown) {
  return {.footprint = rule == ObstacleRule::footprint ? robot.footprint : wend::Footprint(),
          .unknown = allow_unknown ? wend::UnknownPolicy::free : wend::UnknownPolicy::blocked,
          .outside = wend::OutsidePolicy::blocked};
}

}  // namespace wend_nav2
