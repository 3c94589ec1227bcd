#include "wend/path/outline_poses.hpp"

#include <algorithm>
#include <cmath>

#include "wend/path/path_fault.hpp"

namespace wend {
namespace {

/// From outline to outline. The last gap is as long as the others: an outline just before the goal would
/// overlap the one at the goal.
double outline_spacing(double length, double radius) {
  constexpr double kGap = 1.6;  // widths of the robot
  constexpr double kMostGaps = 200;
  constexpr double kRounding = 1e-9;  // so that rounding does not add a pose just before the end
  const double least = 2 * kGap * radius;
  const double gaps = std::clamp(std::floor(length / least + kRounding), 1.0, kMostGaps);
  return std::max(least, length / gaps) * (1 + kRounding);
}

}  // namespace

std::vector<Pose> outline_poses(const Path& path, double radius) {
  if (fault_of(path)) return {};
  return path.visit(
      [&](const JoinedPoses& drive) {
        return poses_along(drive, outline_spacing(path.length(), radius));
      },
      [&](const auto&) { return outline_poses(Polyline(path.points()), radius); });
}

std::vector<Pose> outline_poses(const Polyline& line, double radius) {
  return poses_along(line, outline_spacing(line.length(), radius));
}

}  // namespace wend
