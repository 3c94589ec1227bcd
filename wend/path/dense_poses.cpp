#include "wend/path/dense_poses.hpp"

#include <cstddef>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/path/path_fault.hpp"

namespace wend {

std::vector<Pose> dense_poses(const Path& path, double tolerance) {
  if (fault_of(path)) return {};
  constexpr double kFinest = 1e-6;  // cells
  const double kept = tolerance > kFinest ? tolerance : kFinest;
  if (!path.driven()) return path.poses();
  const std::vector<Pose> joints = path.poses();
  const std::vector<Segment> segments = path.segments();
  std::vector<Pose> poses{joints.front()};
  for (std::size_t joint = 1; joint < joints.size(); ++joint) {
    const Segment& segment = segments[joint - 1];
    const int chords = chord_count(way_of_base(segment), kept);
    for (int i = 1; i < chords; ++i) {
      poses.push_back(pose_on(segment, static_cast<double>(i) / chords));
    }
    poses.push_back(joints[joint]);
  }
  return poses;
}

}  // namespace wend
