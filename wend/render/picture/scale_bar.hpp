#pragma once

// ScaleBar: a bar of a round length, to tell sizes in a picture by.

#include <string>

#include "wend/geometry/frame.hpp"

namespace wend {

struct ScaleBar {
  double pixels = 1;
  std::string label;  // "5 m", "10 cells"
};

/// The longest bar of 1, 2 or 5 times a power of ten that is not longer than `most` pixels. Metres
/// where the frame is metric, else cells, and then at least one.
ScaleBar scale_bar(const Frame& frame, double pixels_a_cell, double most);

}  // namespace wend
