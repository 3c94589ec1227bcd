// SPDX-License-Identifier: Apache-2.0
#include "wend_ros/node_settings.hpp"

#include <cstddef>

#include "wend/base/options.hpp"
#include "wend/base/parse.hpp"
#include "wend_nav2/robot_shape.hpp"

namespace wend_ros {
namespace {

wend::Unexpected<wend::Error> refused(const std::string& parameter, const std::string& why) {
  return wend::Unexpected<wend::Error>(wend::option_text::option_error(parameter, why));
}

wend::Expected<wend::Footprint, wend::Error> polygon_from(const std::vector<double>& numbers) {
  if (numbers.size() % 2 != 0) {
    return refused("footprint", "an even count of numbers expected: x1, y1, x2, y2, ...");
  }
  std::vector<wend::MapPoint> corners;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    corners.push_back({numbers[i], numbers[i + 1]});
  }
  auto footprint = wend_nav2::footprint_from(corners);
  if (!footprint) return refused("footprint", footprint.error().message);
  return footprint;
}

wend::Expected<wend::Footprint, wend::Error> shape_from(const std::string& text) {
  auto footprint = wend_nav2::footprint_from(text);
  if (!footprint) return refused("footprint", footprint.error().message);
  return footprint;
}

}  // namespace

wend::Expected<wend::Footprint, wend::Error> robot_from(const NodeSettings& settings) {
  if (settings.occupied_from < 1 || settings.occupied_from > 100) {
    return refused("occupied_from", std::to_string(settings.occupied_from) + " is not in 1..100");
  }
  if (settings.robot_frame.empty()) return refused("robot_frame", "the name of a frame expected");
  if (!settings.footprint.empty()) return polygon_from(settings.footprint);
  if (!settings.shape.empty()) return shape_from(settings.shape);
  wend::Footprint disc = wend::Footprint::disc(settings.robot_radius);
  if (!disc.valid()) {
    return refused("robot_radius", wend::format_number(settings.robot_radius) +
                                       " is not a length: metres from 0 on expected");
  }
  return disc;
}

}  // namespace wend_ros
