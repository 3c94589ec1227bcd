// SPDX-License-Identifier: Apache-2.0
#pragma once

// CostmapCopy: the costs of a costmap as a session knows them, and what has changed since. Knows no ROS.
//
//   {
//     const std::lock_guard lock(*costmap.getMutex());
//     copy.read(layout, costs);  // compares, and copies the rectangle that differs
//   }
//   copy.bring_to(session, scale);  // an edit of these cells, or another map

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/map/occupancy.hpp"
#include "wend/session/session.hpp"

namespace wend_nav2 {

/// Where the cells of a costmap lie. Cell (0, 0) is the lower left one.
struct CostmapLayout {
  int width = 0;              // cells
  int height = 0;             // cells
  double resolution = 0;      // metres a cell
  wend::MapPoint origin{};    // of the lower left corner, metres
  std::string frame_id = {};  // the costmap's global frame

  std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  wend::Frame frame() const;

  friend bool operator==(const CostmapLayout&, const CostmapLayout&) = default;
};

/// One thread at a time.
class CostmapCopy {
 public:
  /// Takes the costs, row by row, as many as the layout has cells. All that needs the costmap's lock: a comparison
  /// of all bytes and a copy of the rectangle in which they differ.
  void read(const CostmapLayout& layout, std::span<const std::uint8_t> costs);

  /// Gives the session what it has not yet: nothing, an edit, or a map if the layout or the scale is another one.
  /// Without a map, and if the costs are none, fails with invalid_map.
  wend::Expected<void, wend::Error> bring_to(wend::Session& session,
                                             const wend::CostmapScale& scale);

  /// How many maps and edits it has given.
  struct Given {
    std::uint64_t maps = 0;
    std::uint64_t edits = 0;
  };
  const Given& given() const { return given_; }

 private:
  wend::Expected<void, wend::Error> give_whole(wend::Session& session,
                                               const wend::CostmapScale& scale);
  wend::Expected<void, wend::Error> give_change(wend::Session& session,
                                                const wend::CostmapScale& scale);
  void store_patch();

  CostmapLayout layout_;
  std::vector<std::uint8_t> costs_;  // what the session has
  bool whole_ = true;                // costs_ is another map than the session's
  wend::CellBox patch_box_;          // what differs from them; empty if nothing does
  std::vector<std::uint8_t> patch_;  // the costs there
  wend::CostmapScale scale_;         // of the session's map
  Given given_;
};

}  // namespace wend_nav2
