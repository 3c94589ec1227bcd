#pragma once

// CoarseCostField: an estimate of the cost to a goal for a robot that can turn on the spot, on a CoarseGrid, computed only
// where a search asks for it.
//
// The values solve the eikonal equation by first-order upwind differences, so that they grow with the Euclidean
// distance in open space: J. A. Sethian, "A Fast Marching Level Set Method", 1996. They are settled in the order of
// value + distance to the start, as A* does, in buckets; first in first out within a bucket, for a square that is
// settled before both its neighbours towards the goal gets a better value later, and so do all behind it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "wend/base/bucket_queue.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/space/se2/coarse_grid.hpp"
#include "wend/space/se2/motion.hpp"

namespace wend {

class CoarseCostField {
 public:
  /// The grid must outlive the field. O(squares).
  explicit CoarseCostField(const CoarseGrid& grid);

  /// Where the cost is known: at a goal, or from the middles of the squares around it.
  struct Seed {
    Point point;  // on the map
    /// The cost from a point at most `reach` cells from the goal, where nothing is in the way.
    std::function<double(Point)> cost;
    double reach = 0;
  };

  /// Forgets all values. Nothing is computed yet. O(values computed before). From now on settle() asks `stop` now and
  /// then whether it must end before the value is exact; null: never.
  void begin(std::span<const Seed> goals, Point start, std::function<bool()> stop = {});

  struct Value {
    double cost = 0;  // a lower bound of what will be settled, if it is not exact
    bool exact = false;
  };

  /// The cost from a point on the map, interpolated; infinite where no way leads to a goal. O(1).
  Value at(Point point) const;

  /// Settles values until that of the point is exact. O(squares settled).
  void settle(Point point);

  /// The direction in which the cost falls fastest, of length 1; {0, 0} where nothing is known.
  Point descent(Point point) const;

  /// The number of squares settled since begin().
  std::size_t settled() const { return settled_; }

 private:
  /// The four squares whose middles are around a point, and how far it is between them.
  struct Around {
    std::array<std::size_t, 4> squares;  // left and right below, left and right above
    double x;
    double y;
  };

  /// A square that waits to be settled, as it was when it got its value.
  struct Waiting {
    std::uint32_t square;
    float value;
  };

  Around around(Point point) const;
  bool known(std::size_t square) const { return settled_flags_[square] != 0; }
  /// Squares count with the ring around the map, as in their index.
  float key(std::uint32_t column, std::uint32_t row, float value) const;
  void seed(const Seed& goal);
  bool in_sight(int column, int row, int to_column, int to_row) const;
  void improve(std::uint32_t column, std::uint32_t row, std::uint32_t square, float value);
  void expand(const Waiting& from);
  float updated(std::uint32_t square) const;
  bool settle_next();
  void go_to_next_bucket();
  bool exhausted() const { return taken_ == bucket_.size() && queue_.empty(); }

  const CoarseGrid& grid_;
  std::vector<float> values_;
  std::vector<std::uint8_t> settled_flags_;
  std::unique_ptr<std::uint32_t[]> touched_;  // the squares that have got a value
  std::size_t touched_count_ = 0;
  BucketQueue<Waiting, NewestFirst, 256> queue_;
  std::vector<Waiting> bucket_;  // the current one
  std::size_t taken_ = 0;        // from its front
  std::function<bool()> stop_;
  std::size_t settled_ = 0;
  float first_key_ = 0;
  float per_width_;  // buckets in a unit of cost
  float size_;       // of a square
  Point start_;
};

}  // namespace wend
