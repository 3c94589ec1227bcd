#pragma once

// PoseTable: a hash table from boxes of positions and headings to the number of a node. Cleared in O(1).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "wend/base/number_table.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

class PoseTable {
 public:
  static constexpr std::uint32_t kNone = NumberTable<>::kNone;

  /// The size of a box in cells, and the number of boxes of headings, at most 4096.
  PoseTable(double size, int headings) : size_(size), headings_(headings) {}

  void clear() { numbers_.clear(); }
  /// The same, for boxes of another size.
  void clear(double size, int headings) {
    size_ = size;
    headings_ = headings;
    clear();
  }

  /// The node of the box of a pose, for reading and writing; kNone if there is none. Valid until the next call.
  std::uint32_t& operator[](const Pose& pose) { return numbers_[key_of(pose)]; }

 private:
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

  double size_;
  int headings_;
  NumberTable<> numbers_;
};

}  // namespace wend
