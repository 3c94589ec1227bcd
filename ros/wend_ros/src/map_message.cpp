#include "wend_ros/map_message.hpp"

#include <tf2/LinearMath/Quaternion.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace wend_ros {
namespace {

constexpr double kScale = 4;  // terrain of value 100, less 1
constexpr std::int8_t kUnknown = -1;
constexpr std::int8_t kOccupied = 100;
constexpr int kRoughest = 99;

std::int8_t value_of(const wend::GridMap& map, wend::Cell cell) {
  switch (map.state(cell)) {
    case wend::CellState::unknown:
      return kUnknown;
    case wend::CellState::occupied:
      return kOccupied;
    case wend::CellState::free:
      break;
  }
  const double rough = std::round((map.terrain(cell) - 1) * 100 / kScale);
  return static_cast<std::int8_t>(std::clamp(rough, 0.0, static_cast<double>(kRoughest)));
}

wend::Unexpected<wend::Error> wrong(std::string what) {
  return wend::failure(wend::Status::invalid_map, std::move(what));
}

bool is_finite(const geometry_msgs::Pose& pose) {
  const auto& [position, turn] = std::pair(pose.position, pose.orientation);
  const double sum = position.x + position.y + turn.x + turn.y + turn.z + turn.w;
  return std::isfinite(sum);
}

std::string text_of(std::size_t width, std::size_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

/// A float's 0.05 is not a double's: the double that people wrote is that of the shortest decimal
/// which is this float.
double as_written(float value) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double written = value;
  std::from_chars(text.data(), end, written);
  return written;
}

/// The yaw of an orientation. All zeros (an unset message): 0.
double yaw_of(const geometry_msgs::Quaternion& turn) {
  const bool empty = turn.x == 0 && turn.y == 0 && turn.z == 0 && turn.w == 0;
  return empty ? 0 : tf2::getYaw(turn);
}

}  // namespace

nav_msgs::MapMetaData information_of(const wend::GridMap& map) {
  const wend::Frame& frame = map.frame();
  nav_msgs::MapMetaData information;
  information.resolution = static_cast<float>(frame.resolution);
  information.width = static_cast<std::uint32_t>(map.width());
  information.height = static_cast<std::uint32_t>(map.height());
  information.origin.position.x = frame.origin.x;
  information.origin.position.y = frame.origin.y;
  tf2::Quaternion turn;
  turn.setRPY(0, 0, frame.origin.heading);
  information.origin.orientation = tf2::toMsg(turn);
  return information;
}

nav_msgs::OccupancyGrid to_message(const wend::GridMap& map, const std::string& frame_id) {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = frame_id;
  message.info = information_of(map);
  message.data.reserve(map.size());
  for (int n = 0; n < map.height(); ++n) {
    const int y = map.frame().y_up ? n : map.height() - 1 - n;
    for (int x = 0; x < map.width(); ++x) message.data.push_back(value_of(map, {x, y}));
  }
  return message;
}

wend::Expected<wend::GridMap, wend::Error> map_from(const nav_msgs::OccupancyGrid& message,
                                                    const MapReading& reading) {
  const auto& info = message.info;
  const std::size_t width = info.width;
  const std::size_t height = info.height;
  if (width == 0 || height == 0)
    return wrong("the map is empty: " + text_of(width, height) + " cells");
  if (width > wend::GridMap::kMaxCells / height) {
    return wrong("the map is too large: " + text_of(width, height) + " cells");
  }
  if (message.data.size() != width * height) {
    return wrong("the map has " + std::to_string(message.data.size()) + " values, " +
                 text_of(width, height) + " expected");
  }
  if (!(info.resolution > 0) || !std::isfinite(info.resolution)) {
    return wrong("the map's resolution is " + std::to_string(info.resolution) +
                 ": a positive number of metres a cell expected");
  }
  if (!is_finite(info.origin)) return wrong("the map's origin contains NaN or infinity");

  wend::Grid<wend::CellState> cells(static_cast<int>(width), static_cast<int>(height),
                                    wend::CellState::free);
  wend::Grid<double> terrain;
  if (reading.rough) terrain = {static_cast<int>(width), static_cast<int>(height), 1.0};
  for (std::size_t i = 0; i < message.data.size(); ++i) {
    const int value = message.data[i];
    const wend::Cell cell{static_cast<int>(i % width), static_cast<int>(i / width)};
    if (value < 0 || value > kOccupied) {
      cells[cell] = wend::CellState::unknown;
    } else if (value >= reading.occupied_from) {
      cells[cell] = wend::CellState::occupied;
    } else if (reading.rough) {
      terrain[cell] = 1 + kScale * value / 100;
    }
  }
  const wend::Frame frame{
      .resolution = as_written(info.resolution),
      .origin = {info.origin.position.x, info.origin.position.y, yaw_of(info.origin.orientation)},
      .y_up = true,
      .metric = true};
  return *wend::make_grid_map(cells, frame, std::move(terrain));
}

}  // namespace wend_ros
