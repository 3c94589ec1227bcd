#include "wend/path/dense_poses.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/segment.hpp"

namespace wend {
namespace {

/// So many chords keep within the tolerance of an arc.
int pieces_of(const Arc& arc, double tolerance) {
  if (arc.curvature == 0) return 1;
  // The sagitta of a chord that turns by t is (1 - cos(t/2)) / curvature.
  const double cosine = std::max(1 - tolerance * std::abs(arc.curvature), 0.0);
  return std::max(1, static_cast<int>(std::ceil(std::abs(arc.turn()) / (2 * std::acos(cosine)))));
}

}  // namespace

std::vector<Pose> dense_poses(const Path& path, double tolerance) {
  assert(tolerance > 0);
  const std::vector<Pose> joints = path.poses();
  if (!path.driven()) return joints;
  const std::vector<Segment> segments = path.segments();
  std::vector<Pose> poses{joints.front()};
  for (std::size_t joint = 1; joint < joints.size(); ++joint) {
    const Segment& segment = segments[joint - 1];
    const int pieces = pieces_of(way_of_base(segment), tolerance);
    for (int i = 1; i < pieces; ++i) {
      poses.push_back(pose_on(segment, static_cast<double>(i) / pieces));
    }
    poses.push_back(joints[joint]);
  }
  return poses;
}

}  // namespace wend
