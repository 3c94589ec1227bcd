#pragma once

// CellStamps: when the cells of a map were last changed by an update, so that a whole map that is older leaves them as
// they are. Knows no ROS. Takes memory only for rows that have been changed: 8 bytes a cell.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/cell_box.hpp"

namespace wend_ros {

/// Nanoseconds; 0: unknown.
using Stamp = std::int64_t;

class CellStamps {
 public:
  /// Of no map.
  CellStamps() = default;
  /// No cell of a map with so many columns and rows has been changed.
  CellStamps(std::uint32_t width, std::uint32_t height) : width_(width), rows_(height) {}

  /// An update has changed these cells of the map.
  void put(const wend::CellBox& box, Stamp stamp) {
    newest_ = std::max(newest_, stamp);
    for (int y = box.begin.y; y < box.end.y; ++y) {
      std::vector<Stamp>& row = rows_[static_cast<std::size_t>(y)];
      if (row.empty() && stamp == 0) continue;
      if (row.empty()) row.assign(width_, 0);
      std::fill(row.begin() + box.begin.x, row.begin() + box.end.x, stamp);
    }
  }

  /// The newest change, 0 without any.
  Stamp newest() const { return newest_; }

  /// Calls `visit(cell, stamp)` for each cell whose change is newer than that. O(cells of rows that were changed).
  template <class Visit>
  void for_each_newer(Stamp stamp, const Visit& visit) const {
    if (newest_ <= stamp) return;
    for (int y = 0; y < static_cast<int>(rows_.size()); ++y) {
      const std::vector<Stamp>& row = rows_[static_cast<std::size_t>(y)];
      for (int x = 0; x < static_cast<int>(row.size()); ++x) {
        const Stamp at = row[static_cast<std::size_t>(x)];
        if (at > stamp) visit(wend::Cell{x, y}, at);
      }
    }
  }

 private:
  std::size_t width_ = 0;
  std::vector<std::vector<Stamp>> rows_;  // empty: unchanged
  Stamp newest_ = 0;
};

}  // namespace wend_ros
