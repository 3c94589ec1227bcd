#include "wend_ros/map_message.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <cstdint>

#include "wend_ros/pose_message.hpp"

namespace wend_ros {
namespace {

/// A float's 0.05 is not a double's: the double that people wrote is that of the shortest decimal
/// which is this float.
double as_written(float value) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double written = value;
  std::from_chars(text.data(), end, written);
  return written;
}

}  // namespace

nav_msgs::MapMetaData information_of(const wend::GridMap& map) {
  const wend::Frame& frame = map.frame();
  nav_msgs::MapMetaData information;
  information.resolution = static_cast<float>(frame.resolution);
  information.width = static_cast<std::uint32_t>(map.width());
  information.height = static_cast<std::uint32_t>(map.height());
  information.origin = to_message(frame.origin);
  return information;
}

nav_msgs::OccupancyGrid to_message(const wend::GridMap& map, const std::string& frame_id) {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = frame_id;
  message.info = information_of(map);
  message.data.reserve(map.size());
  for (int n = 0; n < map.height(); ++n) {
    const int y = map.frame().y_up ? n : map.height() - 1 - n;
    for (int x = 0; x < map.width(); ++x) message.data.push_back(occupancy_value(map, {x, y}));
  }
  return message;
}

map_msgs::OccupancyGridUpdate update_message(const wend::GridMap& map, const wend::CellBox& box,
                                             const std::string& frame_id) {
  assert(map.frame().y_up && !box.empty());
  map_msgs::OccupancyGridUpdate message;
  message.header.frame_id = frame_id;
  message.x = box.begin.x;
  message.y = box.begin.y;
  message.width = static_cast<std::uint32_t>(box.width());
  message.height = static_cast<std::uint32_t>(box.height());
  message.data.reserve(static_cast<std::size_t>(box.size()));
  for (int y = box.begin.y; y < box.end.y; ++y) {
    for (int x = box.begin.x; x < box.end.x; ++x) {
      message.data.push_back(occupancy_value(map, {x, y}));
    }
  }
  return message;
}

wend::Expected<OccupancyLayout, wend::Error> layout_of(const nav_msgs::OccupancyGrid& message) {
  const auto& info = message.info;
  const auto origin = pose_from(info.origin);
  if (!origin) {
    return wend::failure(wend::Status::invalid_map, "the map's origin " + origin.error());
  }
  return OccupancyLayout{.frame_id = message.header.frame_id,
                         .width = info.width,
                         .height = info.height,
                         .frame = {.resolution = as_written(info.resolution),
                                   .origin = *origin,
                                   .y_up = true,
                                   .metric = true}};
}

OccupancyUpdate update_of(const map_msgs::OccupancyGridUpdate& message) {
  return {.frame_id = message.header.frame_id,
          .x = message.x,
          .y = message.y,
          .width = message.width,
          .height = message.height,
          .values = message.data};
}

wend::Expected<wend::GridMap, wend::Error> map_from(const nav_msgs::OccupancyGrid& message,
                                                    const MapReading& reading) {
  const auto layout = layout_of(message);
  if (!layout) return wend::Unexpected<wend::Error>(layout.error());
  return map_from(*layout, message.data, reading);
}

}  // namespace wend_ros
