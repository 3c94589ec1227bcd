#pragma once

// OccupancyMap: the values of the map messages so far, and what the next message changes. A map of the same
// layout as the one before is an edit of the cells that differ; so is an update. Knows no ROS.
//
// Whole maps and updates come by two topics, in no common order: their stamps decide. A whole map leaves cells as they
// are that a newer update has changed; an update that is older than the whole map is not used. Messages without a
// stamp, and those of one topic, count in the order in which they come.
//
//   auto change = map.take(update);
//   if (!change) return warn(change.error().message);
//   session.edit(*change);

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/map_edit.hpp"
#include "wend/map/value_rows.hpp"
#include "wend_ros/cell_stamps.hpp"
#include "wend_ros/occupancy.hpp"

namespace wend_ros {

/// Does an edit name no cells?
bool is_empty(const wend::MapEdit& edit);

/// Values of cells, row by row.
using ValueRows = wend::ValueRows<std::int8_t>;

class OccupancyMap {
 public:
  /// Without a map.
  explicit OccupancyMap(MapReading reading = {}) : reading_(reading) {}

  /// What a message makes of the map.
  struct Change {
    std::optional<wend::GridMap> whole;  // another map
    wend::MapEdit edit;                  // else the cells that differ
    bool keeps_newer = false;            // newer updates lie over the whole map that came
  };

  /// Replaces the map. If the values are not a map, fails with invalid_map and has no map from then on. O(cells).
  wend::Expected<Change, wend::Error> take(OccupancyLayout layout,
                                           std::span<const std::int8_t> values, Stamp stamp = 0);

  /// Changes some cells. If there is no map, or the update does not fit it or is older, fails with invalid_map and
  /// changes nothing. O(values).
  wend::Expected<wend::MapEdit, wend::Error> take(const OccupancyUpdate& update, Stamp stamp = 0);

  /// There is no map from now on.
  void clear() { values_ = {}; }

  /// The stamp of the newest message in the map; 0: unknown.
  Stamp stamp() const { return stamp_; }

  /// Reads the values in another way. True if there is a map, which is another one then.
  bool read_as(const MapReading& reading);

  bool empty() const { return values_.empty(); }
  const OccupancyLayout& layout() const { return layout_; }

  /// The map of all messages so far; there must be one. O(cells).
  wend::GridMap whole() const;

 private:
  std::string fault_of_update(const OccupancyUpdate& update, Stamp stamp) const;
  CellStamps keep_newer(const OccupancyLayout& layout, std::span<std::int8_t> values,
                        Stamp stamp) const;
  wend::MapEdit edit_to(const ValueRows& values, const wend::CellBox& box) const;
  void store(const ValueRows& values, const wend::CellBox& box);

  MapReading reading_;
  OccupancyLayout layout_;
  std::vector<std::int8_t> values_;  // empty without a map
  Stamp whole_stamp_ = 0;            // of the last whole map
  Stamp stamp_ = 0;
  CellStamps updates_;  // newer than the whole map
};

}  // namespace wend_ros
