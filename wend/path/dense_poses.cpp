#include "wend/path/dense_poses.hpp"

#include <algorithm>
#include <cstddef>

#include "wend/geometry/arc.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/path/chord_counts.hpp"
#include "wend/path/path_fault.hpp"

namespace wend {

std::vector<Pose> dense_poses(const Path& path, double tolerance) {
  if (fault_of(path)) return {};
  constexpr double kFinest = 1e-6;  // cells
  const double kept = tolerance > kFinest ? tolerance : kFinest;
  if (!path.driven()) return path.poses();
  const std::vector<Pose> joints = path.poses();
  const std::vector<Segment> segments = path.segments();
  std::vector<Arc> arcs(segments.size());
  std::ranges::transform(segments, arcs.begin(),
                         [](const Segment& segment) { return way_of_base(segment); });
  const std::vector<int> counts = chord_counts(arcs, kept);
  std::vector<Pose> poses{joints.front()};
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (int k = 1; k < counts[i]; ++k) {
      poses.push_back(pose_on(segments[i], static_cast<double>(k) / counts[i]));
    }
    poses.push_back(joints[i + 1]);
  }
  return poses;
}

}  // namespace wend
