#pragma once

// HybridResolution: how finely a hybrid A* search looks at poses and motions. Lengths are in cells.

namespace wend {

struct HybridResolution {
  double position = 2;    // size of the boxes of which one pose is kept
  int headings = 36;      // the number of boxes of headings
  double step = 4;        // length of a primitive
  double wide_room = 10;  // primitives are twice as long where there is this room beside the robot
  double trace_spacing = 20;  // one trace for each box of this size and a twelfth of a turn
  int trace_period = 4;       // a trace at every fourth primitive
  double weight = 1.03;       // of the heuristic
  bool to_contact = false;    // primitives go on until the robot touches something
};

/// The same for boxes and motions that are `times` smaller.
inline HybridResolution times_finer(HybridResolution resolution, int times) {
  resolution.position /= times;
  resolution.headings *= times;
  resolution.step /= times;
  return resolution;
}

}  // namespace wend
