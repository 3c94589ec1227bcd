#include "lab/wasm/drawn_points.hpp"

#include <cmath>

#include "wend/geometry/arc.hpp"

namespace wend::lab {
namespace {

constexpr double kTurnOfALine = 0.1;  // radians

}  // namespace

std::vector<double> drawn_points(const Path& path) {
  std::vector<double> points;
  const auto append = [&](const Pose& pose) {
    points.insert(points.end(), {pose.x, pose.y, pose.heading});
  };
  const std::vector<Pose> poses = path.poses();
  const std::vector<Arc> arcs = path.arcs();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    append(poses[i]);
    if (i >= arcs.size()) continue;
    const Arc& arc = arcs[i];
    const int lines = static_cast<int>(std::ceil(std::abs(arc.turn()) / kTurnOfALine));
    for (int line = 1; line < lines; ++line) append(pose_on(arc, arc.length * line / lines));
  }
  return points;
}

}  // namespace wend::lab
