#pragma once

// Masks: files of keep-out zones and speed limits, which lie over every map that comes, and over its edits. Knows no
// ROS.
//
//   Masks masks = Masks::of({"keepout:zones.yaml", "speed:slow.yaml"});
//   auto map = masks.lay_over(bare_map);
//   session.edit(masks.over(edit));

#include <optional>
#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/map_edit.hpp"

namespace wend_ros {

class Masks {
 public:
  /// Reads texts as wend::parse_mask_spec() does, and their files. A mask that cannot be read is an error of
  /// lay_over() from then on: a robot must not drive where its zones are not known.
  static Masks of(const std::vector<std::string>& specs);

  bool empty() const { return masks_.empty(); }

  /// Why a mask cannot be read, a line for each that cannot.
  std::vector<std::string> faults() const;

  /// What is unusual or probably not meant in the files of the masks, a line each.
  std::vector<std::string> notes() const;

  /// The map under the masks, or why one of them does not fit. Later edits are those of this map. O(cells).
  wend::Expected<wend::GridMap, wend::Error> lay_over(wend::GridMap map);

  /// An edit of the map as one of the map under the masks. O(cells of the edit).
  wend::MapEdit over(wend::MapEdit edit) const;

 private:
  struct Mask {
    std::string spec;
    wend::Expected<wend::GridMap, wend::Error> map;
    std::vector<std::string> notes;
  };

  std::vector<Mask> masks_;
  std::optional<wend::GridMap> on_grid_;  // all of them, on the grid of the last map
};

}  // namespace wend_ros
