#pragma once

// Drive: the motions of a path, one after the other, with the pose before each.

#include <vector>

#include "wend/geometry/pose.hpp"
#include "wend/space/se2/motion.hpp"
#include "wend/space/se2/motion_check.hpp"
#include "wend/space/se2/steering.hpp"

namespace wend {

struct DrivenMotion {
  Pose from;
  Motion motion;
};

using Drive = std::vector<DrivenMotion>;

/// The cost of a drive that fits, in cells, with its changes of gear.
double cost_of(const Drive& drive, const MotionCheck& check, const Steering& steering);

/// The same drive, with one motion where several of the same curvature follow each other.
Drive joined(const Drive& drive);

/// A drive between the same poses that costs at most as much: where a connection between two poses of the drive is
/// cheaper, it takes that. As Dijkstra's algorithm over some poses of the drive and connections of some lengths.
Drive shortened(const Drive& drive, const MotionCheck& check, const Steering& steering,
                double spacing);

}  // namespace wend
