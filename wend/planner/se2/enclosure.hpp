#pragma once

// is_enclosed(): a proof that a robot cannot get from one pose to another, however it moves.
//
// Positions and headings are cut into boxes. A box counts as free if the robot fits at its middle after it has been made
// smaller by what it moves within the box: so every box that holds a free pose does. A flood through these boxes that
// ends without the other pose shows that no motion leads there, not even of a robot that slides and turns at will.

#include <functional>

#include "wend/geometry/pose.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// True only if no motion of the robot leads from one pose to the other. It looks at some ten thousand boxes, and knows
/// nothing of discs and of polygons with a hollow.
/// It gives up, and says false, once `stop` says so; it asks after some hundred boxes.
bool is_enclosed(const FreeSpace& space, const Pose& pose, const Pose& other,
                 const std::function<bool()>& stop);

}  // namespace wend
