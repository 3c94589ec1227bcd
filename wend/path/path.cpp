#include "wend/path/path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>

namespace wend {

Path Path::through(std::vector<Pose> poses) {
  Path path;
  path.poses_ = std::move(poses);
  return path;
}

double Path::length() const {
  if (driven()) {
    double length = 0;
    for (const Arc& arc : arcs()) length += std::abs(arc.length);
    return length;
  }
  std::uint64_t straight = 0;
  std::uint64_t diagonal = 0;
  double other = 0;
  for (std::size_t i = 1; i < cells_.size(); ++i) {
    const int dx = std::abs(cells_[i].x - cells_[i - 1].x);
    const int dy = std::abs(cells_[i].y - cells_[i - 1].y);
    if (dx + dy == 1) {
      ++straight;
    } else if (dx == 1 && dy == 1) {
      ++diagonal;
    } else {
      other += std::hypot(dx, dy);
    }
  }
  return static_cast<double>(straight) + std::numbers::sqrt2 * static_cast<double>(diagonal) +
         other;
}

std::vector<Pose> Path::poses() const {
  if (driven()) return poses_;
  std::vector<Pose> poses;
  poses.reserve(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    double heading = i > 0 ? poses.back().heading : 0;
    if (i + 1 < cells_.size() && cells_[i + 1] != cells_[i]) {
      heading = std::atan2(cells_[i + 1].y - cells_[i].y, cells_[i + 1].x - cells_[i].x);
    }
    poses.push_back(pose_at(cells_[i], heading));
  }
  return poses;
}

std::vector<Arc> Path::arcs() const {
  std::vector<Arc> arcs;
  if (!driven()) return arcs;
  arcs.reserve(poses_.size() - 1);
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    arcs.push_back(arc_to(poses_[i - 1], poses_[i].point()));
  }
  return arcs;
}

std::vector<Point> Path::points_in_metres(const Frame& frame) const {
  std::vector<Point> points;
  points.reserve(size());
  for (const Cell cell : cells_) points.push_back(frame.to_metres(centre_of(cell)));
  for (const Pose& pose : poses_) points.push_back(frame.to_metres(pose.point()));
  return points;
}

void Path::clear() {
  cells_.clear();
  poses_.clear();
}

void Path::reverse() {
  std::reverse(cells_.begin(), cells_.end());
  std::reverse(poses_.begin(), poses_.end());
}

}  // namespace wend
