#pragma once

// DiscRing: where the base point of a robot can be that lies outside the robot's polygon. The centre of the robot's
// inner disc is always at the same distance from it: so the base point can be in the cells on whose ring there is a cell
// for the centre.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

/// Where in its cell a base point is.
enum class BasePlace {
  middle,    // in the middle
  anywhere,  // anywhere, also on the edge
};

class WEND_API DiscRing {
 public:
  /// The largest ring, in cells. On a larger one every cell counts as one for the centre.
  static constexpr int kMostReach = 256;

  /// `distance`: from the base point to the centre of the disc, in cells.
  DiscRing(double distance, BasePlace place);

  /// The most columns, and rows, from a cell to one on its ring.
  int reach() const { return reach_; }

  /// Sets the bits in the words that a box of the map touches: of the cells on whose ring there is a cell of
  /// `centres`, or, with `outside`, a cell outside the map. The centre may be anywhere in its cell. O(words of the
  /// box, times cells on a ring).
  void spread(const BitGrid& centres, bool outside, const CellBox& box, BitGrid& cells) const;

 private:
  /// In rows at one distance, above and below: the columns from `first` to `last`, to the right and to the left.
  struct Columns {
    int first;
    int last;
  };

  std::uint64_t on_row(std::span<const std::uint64_t> centres, std::size_t word,
                       int distance) const;

  int reach_ = 0;
  std::vector<Columns> rows_;  // by the distance of the row; empty if the ring is too large
};

}  // namespace wend
