#pragma once

// Masks of planner_server: files of keep-out zones and speed limits, which lie over every map that comes.

#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/map/grid_map.hpp"

namespace ros {
class NodeHandle;
}

namespace wend_ros {

class Masks {
 public:
  /// Reads ~masks: a list of "keepout:FILE" and "speed:FILE", or a text with commas between them. A mask that
  /// cannot be read is an error of over() from then on: the robot must not drive where it does not know the zones.
  static Masks of_parameter(const ros::NodeHandle& own);

  /// The same from texts.
  static Masks of(const std::vector<std::string>& specs);

  /// The map under the masks, or why one does not fit.
  wend::Expected<wend::GridMap, wend::Error> over(
      wend::Expected<wend::GridMap, wend::Error> map) const;

 private:
  struct Mask {
    std::string spec;
    wend::Expected<wend::GridMap, wend::Error> map;
  };

  std::vector<Mask> masks_;
};

}  // namespace wend_ros
