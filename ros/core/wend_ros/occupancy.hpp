#pragma once

// Occupancy: what the values of nav_msgs/OccupancyGrid and map_msgs/OccupancyGridUpdate say of cells, and
// whether a message fits. Knows no ROS: the fuzzers use it too.
//
// A value is -1 (unknown), 100 (occupied), or 0 to 99: free, and the rougher the higher: terrain
// 1 + 4 v / 100, as map.yaml's `mode: scale` has it. Every other value is unknown. Row 0 is at the bottom.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "wend/base/error.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/map/grid_map.hpp"

namespace wend_ros {

inline constexpr std::int8_t kUnknownValue = -1;
inline constexpr std::int8_t kOccupiedValue = 100;
inline constexpr int kRoughestValue = 99;
inline constexpr double kTerrainScale = 4;  // terrain of the value 100, less 1

struct MapReading {
  int occupied_from = 65;  // values of 1 to 99 that are obstacles; map_server's usual threshold
  bool rough = false;      // lower ones are rough ground, else free
  double cost_factor = kTerrainScale;  // a rough one v costs 1 + cost_factor v / 100

  friend bool operator==(const MapReading&, const MapReading&) = default;
};

/// What a value says of its cell.
struct CellReading {
  wend::CellState state = wend::CellState::free;
  double terrain = 1;
};

CellReading read_cell(std::int8_t value, const MapReading& reading);

/// The value of a cell: the nearest one, of a rough cell less than 100.
std::int8_t occupancy_value(const wend::GridMap& map, wend::Cell cell);

/// Where the cells of a map lie.
struct OccupancyLayout {
  std::string frame_id = {};
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  wend::Frame frame;

  std::size_t size() const { return std::size_t{width} * height; }
  friend bool operator==(const OccupancyLayout&, const OccupancyLayout&) = default;
};

/// New values of a rectangle of cells, as in a message.
struct OccupancyUpdate {
  std::string_view frame_id = {};  // empty: the map's
  std::int32_t x = 0;              // the least column
  std::int32_t y = 0;              // the least row
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::span<const std::int8_t> values;  // row by row
};

/// The error if the number of values does not fit the layout: "the map has 15 values, 4 x 4 expected". Empty if it fits.
std::string fault_of(const OccupancyLayout& layout, std::size_t values);

/// The error if an update does not fit a map, empty if it fits: "it covers columns 8 to 11 and rows 0 to 3, and
/// the map has 10 x 10 cells: columns 0 to 9, rows 0 to 9".
std::string fault_of(const OccupancyUpdate& update, const OccupancyLayout& layout);

/// The map of these values. Fails with invalid_map as fault_of() says. O(cells).
wend::Expected<wend::GridMap, wend::Error> map_from(const OccupancyLayout& layout,
                                                    std::span<const std::int8_t> values,
                                                    const MapReading& reading);

}  // namespace wend_ros
