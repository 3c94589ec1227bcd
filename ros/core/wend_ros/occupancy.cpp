#include "wend_ros/occupancy.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "wend/io/text.hpp"

namespace wend_ros {
namespace {

std::string text_of(std::uint64_t width, std::uint64_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

/// "columns 3 to 7".
std::string range(const std::string& name, std::int64_t first, std::uint32_t count) {
  return name + ' ' + std::to_string(first) + " to " + std::to_string(first + count - 1);
}

}  // namespace

CellReading read_cell(std::int8_t value, const MapReading& reading) {
  if (value < 0 || value > kOccupiedValue) return {wend::CellState::unknown};
  if (value >= reading.occupied_from) return {wend::CellState::occupied};
  return {wend::CellState::free, reading.rough ? 1 + reading.cost_factor * value / 100 : 1};
}

std::int8_t occupancy_value(const wend::GridMap& map, wend::Cell cell) {
  switch (map.state(cell)) {
    case wend::CellState::unknown:
      return kUnknownValue;
    case wend::CellState::occupied:
      return kOccupiedValue;
    case wend::CellState::free:
      break;
  }
  const double rough = std::round((map.terrain(cell) - 1) * 100 / kTerrainScale);
  return static_cast<std::int8_t>(std::clamp(rough, 0.0, static_cast<double>(kRoughestValue)));
}

std::string fault_of(const OccupancyLayout& layout, std::size_t values) {
  const std::size_t width = layout.width;
  const std::size_t height = layout.height;
  if (width == 0 || height == 0) return "the map is empty: " + text_of(width, height) + " cells";
  if (width > wend::GridMap::kMaxCells / height) {
    return "the map is too large: " + text_of(width, height) + " cells";
  }
  if (values != width * height) {
    return "the map has " + std::to_string(values) + " values, " + text_of(width, height) +
           " expected";
  }
  const double resolution = layout.frame.resolution;
  if (!(resolution > 0) || !std::isfinite(resolution)) {
    return "the map's resolution is " + std::to_string(resolution) +
           ": a positive number of metres a cell expected";
  }
  const wend::MapPose& origin = layout.frame.origin;
  if (!std::isfinite(origin.x + origin.y + origin.heading)) {
    return "the map's origin contains NaN or infinity";
  }
  return {};
}

std::string fault_of(const OccupancyUpdate& update, const OccupancyLayout& layout) {
  if (!update.frame_id.empty() && update.frame_id != layout.frame_id) {
    return "it is in the frame " + wend::quote(update.frame_id) + ", and the map is in " +
           wend::quote(layout.frame_id);
  }
  const std::uint64_t cells = std::uint64_t{update.width} * update.height;
  if (update.values.size() != cells) {
    return "it has " + std::to_string(update.values.size()) + " values, " +
           text_of(update.width, update.height) + " = " + std::to_string(cells) + " expected";
  }
  if (cells == 0) return {};
  const bool inside = update.x >= 0 && update.y >= 0 &&
                      std::int64_t{update.x} + update.width <= layout.width &&
                      std::int64_t{update.y} + update.height <= layout.height;
  if (inside) return {};
  return "it covers " + range("columns", update.x, update.width) + " and " +
         range("rows", update.y, update.height) + ", and the map has " +
         text_of(layout.width, layout.height) + " cells: " + range("columns", 0, layout.width) +
         ", " + range("rows", 0, layout.height);
}

wend::Expected<wend::GridMap, wend::Error> map_from(const OccupancyLayout& layout,
                                                    std::span<const std::int8_t> values,
                                                    const MapReading& reading) {
  std::string fault = fault_of(layout, values.size());
  if (!fault.empty()) return wend::failure(wend::Status::invalid_map, std::move(fault));
  const auto width = static_cast<int>(layout.width);
  const auto height = static_cast<int>(layout.height);
  wend::Grid<wend::CellState> cells(width, height, wend::CellState::free);
  wend::Grid<double> terrain;
  if (reading.rough) terrain = {width, height, 1.0};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const CellReading read = read_cell(values[i], reading);
    const wend::Cell cell{static_cast<int>(i % layout.width), static_cast<int>(i / layout.width)};
    cells[cell] = read.state;
    if (reading.rough) terrain[cell] = read.terrain;
  }
  return wend::make_grid_map(cells, layout.frame, std::move(terrain));
}

}  // namespace wend_ros
