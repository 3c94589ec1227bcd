#pragma once

// Hills: a smooth random landscape, for terrain and for patches of whatever a generator strews.

#include <cstdint>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/map/grid.hpp"

namespace wend {

class Hills {
 public:
  /// Hills that are `spacing` cells apart, roughly, with smaller ones on them.
  Hills(int width, int height, int spacing, Random& random);

  /// The share of all cells that lie lower than this one, in [0, 1). The cells from 1 - s on are a
  /// share of s, in patches.
  double share_below(Cell cell) const { return share_below_[heights_[cell]]; }

 private:
  Grid<std::uint16_t> heights_;
  std::vector<double> share_below_;  // by height
};

}  // namespace wend
