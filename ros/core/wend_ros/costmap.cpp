#include "wend_ros/costmap.hpp"

#include "wend/map/occupancy.hpp"

namespace wend_ros {

wend::Expected<wend::GridMap, wend::Error> map_from_costs(std::span<const std::uint8_t> costs,
                                                          int width, int height, double resolution,
                                                          wend::MapPoint origin,
                                                          double cost_factor) {
  return wend::map_from_costmap(
      costs, width, height,
      {.resolution = resolution, .origin = {origin.x, origin.y, 0}, .y_up = true, .metric = true},
      {cost_factor});
}

}  // namespace wend_ros
