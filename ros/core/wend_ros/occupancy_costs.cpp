// SPDX-License-Identifier: Apache-2.0
#include "wend_ros/occupancy_costs.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace wend_ros {
namespace {

constexpr std::uint8_t kUnknownCost = 255;
constexpr std::uint8_t kLethalCost = 254;
constexpr double kCostOfValue = 2.52;

wend::Unexpected<wend::Error> no_map(std::string message) {
  return wend::Unexpected<wend::Error>({wend::Status::invalid_map, std::move(message)});
}

}  // namespace

std::uint8_t OccupancyCosts::cost_of(std::int8_t value) const {
  if (value < 0 || value > kOccupiedValue) return kUnknownCost;
  if (value >= occupied_from_) return kLethalCost;
  return static_cast<std::uint8_t>(std::lround(value * kCostOfValue));
}

wend::Expected<void, wend::Error> OccupancyCosts::take(const OccupancyLayout& layout,
                                                       std::span<const std::int8_t> values) {
  costs_.clear();
  if (std::string fault = fault_of(layout, values.size()); !fault.empty()) {
    return no_map(std::move(fault));
  }
  if (layout.frame.origin.heading != 0) {
    return no_map("the map's origin is turned; an origin without a rotation expected");
  }
  map_ = layout;
  layout_ = {.width = static_cast<int>(layout.width),
             .height = static_cast<int>(layout.height),
             .resolution = layout.frame.resolution,
             .origin = layout.frame.origin.point(),
             .frame_id = layout.frame_id};
  costs_.reserve(values.size());
  for (const std::int8_t value : values) costs_.push_back(cost_of(value));
  return {};
}

wend::Expected<void, wend::Error> OccupancyCosts::take(const OccupancyUpdate& update) {
  if (empty()) return no_map("an update came before a map");
  if (std::string fault = fault_of(update, map_); !fault.empty()) return no_map(std::move(fault));
  for (std::uint32_t row = 0; row < update.height; ++row) {
    const std::size_t to = (static_cast<std::size_t>(update.y) + row) * map_.width +
                           static_cast<std::size_t>(update.x);
    for (std::uint32_t column = 0; column < update.width; ++column) {
      costs_[to + column] =
          cost_of(update.values[static_cast<std::size_t>(row) * update.width + column]);
    }
  }
  return {};
}

}  // namespace wend_ros
