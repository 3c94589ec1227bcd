#pragma once

// What is left of a path of poses for a robot of hybrid_astar that has driven along it: from where the robot is, which
// may be beside the path. Then the cheapest connection that fits leads to a pose ahead.

#include <optional>
#include <span>

#include "wend/geometry/pose.hpp"
#include "wend/planner/rest_of_path.hpp"
#include "wend/planner/se2/drive.hpp"
#include "wend/space/se2/motion_check.hpp"
#include "wend/space/se2/steering.hpp"

namespace wend {

struct RestOfDrive {
  Path path;  // behind the connection, its poses are those of the path
  double cost = 0;
};

/// `place` is the place on the path nearest to the robot. Nothing if a motion is not free any more, or nothing
/// connects the robot with the path. O(cells of the way).
std::optional<RestOfDrive> rest_of_drive(std::span<const Pose> poses, const PlaceOnDrive& place,
                                         const Pose& robot, const MotionCheck& check,
                                         const Steering& steering);

}  // namespace wend
