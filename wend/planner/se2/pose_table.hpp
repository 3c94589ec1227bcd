#pragma once

// PoseTable: a hash table from boxes of positions and headings to the number of a node. Cleared in O(1).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

class PoseTable {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// The size of a box in cells, and the number of boxes of headings, at most 4096.
  PoseTable(double size, int headings) : size_(size), headings_(headings), slots_(kFirst) {}

  void clear() {
    count_ = 0;
    ++round_;
  }
  /// The same, for boxes of another size.
  void clear(double size, int headings) {
    size_ = size;
    headings_ = headings;
    clear();
  }

  /// The node of the box of a pose, for reading and writing; kNone if there is none. Valid until the next call.
  std::uint32_t& operator[](const Pose& pose) {
    if (2 * count_ >= slots_.size()) grow();
    Slot& slot = slot_of(key_of(pose));
    if (slot.round != round_) {
      slot = {key_of(pose), kNone, round_};
      ++count_;
    }
    return slot.node;
  }

 private:
  static constexpr std::size_t kFirst = 1024;

  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t node = kNone;
    std::uint32_t round = 0;
  };

  std::uint64_t key_of(const Pose& pose) const {
    // Boxes of absurdly small motions have no number of their own.
    const auto box = [](double value) {
      constexpr double kMost = 1 << 24;
      const double number = value > -kMost ? std::min(std::floor(value), kMost) : -kMost;
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(number) + (1 << 24));
    };
    const double turn = pose.heading / (2 * kPi);
    const auto nearest =
        static_cast<std::uint64_t>(std::lround((turn - std::floor(turn)) * headings_));
    const std::uint64_t heading = nearest % static_cast<std::uint64_t>(headings_);
    return (box(pose.x / size_) << 38U | box(pose.y / size_) << 12U) | heading;
  }

  Slot& slot_of(std::uint64_t key) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = (key * 0x9E3779B97F4A7C15U >> 20U) & mask;
    while (slots_[i].round == round_ && slots_[i].key != key) i = (i + 1) & mask;
    return slots_[i];
  }

  void grow() {
    std::vector<Slot> old(slots_.size() * 2);
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.round == round_) slot_of(slot.key) = slot;
    }
  }

  double size_;
  int headings_;
  std::vector<Slot> slots_;
  std::size_t count_ = 0;
  std::uint32_t round_ = 1;
};

}  // namespace wend
