#pragma once

// MapHistory: the changes of a map that a test publishes, by their stamps, and the map as it was at one of them.

#include <ros/time.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace wend_ros {

/// A map of square cells in rows, of values of messages.
struct ValueMap {
  int side;
  std::vector<std::int8_t> values;

  explicit ValueMap(int cells) : side(cells), values(static_cast<std::size_t>(cells * cells), 0) {}
  std::int8_t& at(int x, int y) { return values[static_cast<std::size_t>(y * side + x)]; }
  std::int8_t at(int x, int y) const { return values[static_cast<std::size_t>(y * side + x)]; }
};

/// A square of cells that have all one value from then on.
struct SquareChange {
  ros::Time stamp;
  int x;
  int y;
  int cells;  // of a side
  std::int8_t value;
};

inline void apply(const SquareChange& change, ValueMap& map) {
  for (int y = change.y; y < change.y + change.cells; ++y) {
    for (int x = change.x; x < change.x + change.cells; ++x) map.at(x, y) = change.value;
  }
}

/// All changes, which one thread adds and others read.
class MapHistory {
 public:
  void add(const SquareChange& change) {
    const std::lock_guard lock(mutex_);
    changes_.push_back(change);
  }

  /// The change with this number, if there is one yet.
  bool get(std::size_t number, SquareChange& change) const {
    const std::lock_guard lock(mutex_);
    if (number >= changes_.size()) return false;
    change = changes_[number];
    return true;
  }

 private:
  mutable std::mutex mutex_;
  std::deque<SquareChange> changes_;
};

/// The map at one stamp after the other.
class MapReplay {
 public:
  MapReplay(const MapHistory& history, ValueMap first)
      : history_(history), map_(std::move(first)) {}

  /// Goes on to this stamp; false if no change had it, or an earlier one was asked for.
  bool go_to(ros::Time stamp) {
    SquareChange change{};
    while (stamp_ < stamp && history_.get(next_, change)) {
      apply(change, map_);
      stamp_ = change.stamp;
      ++next_;
    }
    return stamp_ == stamp;
  }

  const ValueMap& map() const { return map_; }

 private:
  const MapHistory& history_;
  ValueMap map_;
  std::size_t next_ = 0;
  ros::Time stamp_;
};

}  // namespace wend_ros
