#pragma once

// Routes of lists of poses whose source cannot say whether their headings count: messages of other
// programs (nav_msgs/Path), files without a word about it. A wend::Path knows it: Path::driven().
//
//   const auto route = wend::given_route(poses);  // metres, in the frame of the robot's poses
//   if (!route) return report(route.error().message);
//   follower.follow(*route);
//
// The rule: headings count if they change between the first pose and the last, which may be the robot's
// and the goal's own. Where they are all the same there, a source without headings may have filled them
// in (with zeros, mostly): they count only if the robot can drive each piece with them, ahead, in reverse or
// turning in place, within 10 degrees. So a straight line in reverse at heading 0 is driven in reverse, and
// a line with a bend and zeros everywhere is driven ahead.

#include <span>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/control/route.hpp"
#include "wend/geometry/map_pose.hpp"

namespace wend {

/// Do the headings of these poses count, or did their source only fill them in? The rule above. The last
/// heading is the goal's in either case. False for fewer than two poses. O(n).
WEND_API bool headings_count(std::span<const MapPose> poses);

/// The route along poses in metres, by straight lines, with a leg for each stretch between reversals, turns
/// in place, and bends of more than a right angle; it ends with the heading of the last pose. Refuses an
/// empty list, and poses that are not finite or farther than Route::kFarthest from the origin; Error::where
/// names the pose. O(n).
WEND_API Expected<Route, Error> given_route(std::span<const MapPose> poses);

}  // namespace wend
