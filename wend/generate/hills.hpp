#pragma once

// Hills: a smooth random landscape, for terrain and for patches of anything that a generator places.

#include <cstdint>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/map/grid.hpp"

namespace wend {

class Hills {
 public:
  /// Makes hills that are roughly `spacing` cells apart, with smaller ones on them.
  Hills(int width, int height, int spacing, Random& random);

  /// The fraction of all cells that lie lower than this one, in [0, 1). The cells from 1 - s on are a
  /// fraction s of the map, in patches.
  double share_below(Cell cell) const { return share_below_[heights_[cell]]; }

 private:
  Grid<std::uint16_t> heights_;
  std::vector<double> share_below_;  // by height
};

}  // namespace wend
