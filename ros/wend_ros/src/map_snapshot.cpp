#include "wend_ros/map_snapshot.hpp"

#include <utility>

namespace wend_ros {

void MapHolder::set_map(wend::GridMap map, std::string frame_id) {
  const std::lock_guard lock(mutex_);
  map_ = std::move(map);
  frame_id_ = std::move(frame_id);
  wrong_.clear();
  snapshot_.reset();
  ++version_;
}

void MapHolder::set_wrong(std::string why) {
  const std::lock_guard lock(mutex_);
  map_.reset();
  snapshot_.reset();
  wrong_ = std::move(why);
  ++version_;
}

void MapHolder::set_robot(const wend::FreeSpaceOptions& options) {
  const std::lock_guard lock(mutex_);
  if (options == robot_) return;
  robot_ = options;
  snapshot_.reset();
  ++version_;
}

std::shared_ptr<const MapSnapshot> MapHolder::snapshot() {
  // Making it under the lock lets a second caller wait for it, not make another.
  const std::lock_guard lock(mutex_);
  if (!snapshot_ && map_) {
    auto space = wend::make_free_space(*map_, robot_);
    if (!space) {
      wrong_ = space.error().message;
      return nullptr;
    }
    snapshot_ =
        std::make_shared<const MapSnapshot>(MapSnapshot{*std::move(space), frame_id_, version_});
  }
  return snapshot_;
}

std::string MapHolder::why_none() const {
  const std::lock_guard lock(mutex_);
  return wrong_.empty() ? "no map has come yet" : wrong_;
}

}  // namespace wend_ros
