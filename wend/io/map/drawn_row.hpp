#pragma once

// Which row of a map is drawn where.

namespace wend {

/// The map row that is drawn `from_top` rows below the top one, or the other way round: with y up
/// row 0 is the bottom row.
constexpr int drawn_row(int from_top, int height, bool y_up) {
  return y_up ? height - 1 - from_top : from_top;
}

}  // namespace wend
