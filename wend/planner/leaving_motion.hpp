#pragma once

// LeavingMotion: what a robot with headings can drive to leave a place where it does not fit.

#include <vector>

#include "wend/geometry/segment.hpp"

namespace wend {

/// A motion in grid coordinates: segments, each of which begins where the one before ends.
struct LeavingMotion {
  std::vector<Segment> segments;  // at least one
  bool ends_anywhere = false;     // may it end at each of its poses, or only at the last one?
};

}  // namespace wend
