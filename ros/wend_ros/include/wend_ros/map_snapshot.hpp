#pragma once

// MapSnapshot: the map that a query plans on, whatever comes in meanwhile.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "wend/robot/free_space.hpp"

namespace wend_ros {

struct MapSnapshot {
  wend::FreeSpace space;
  std::string frame_id;
  std::uint64_t version;  // grows with every map and every change of what the robot is
};

/// The newest map, as the robot of the newest options sees it. All threads may call everything.
class MapHolder {
 public:
  void set_map(wend::GridMap map, std::string frame_id);
  void set_wrong(std::string why);  // a message came that is no map
  void set_robot(const wend::FreeSpaceOptions& options);

  /// Null before the first map. O(cells) for the first caller after a change, then O(1).
  std::shared_ptr<const MapSnapshot> snapshot();

  /// Why there is no map.
  std::string why_none() const;

 private:
  mutable std::mutex mutex_;
  std::optional<wend::GridMap> map_;
  std::string frame_id_;
  std::string wrong_;
  wend::FreeSpaceOptions robot_;
  std::uint64_t version_ = 0;
  std::shared_ptr<const MapSnapshot> snapshot_;
};

}  // namespace wend_ros
