// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_poses.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "wend/path/path_collision.hpp"

namespace wend_nav2 {
namespace {

/// The poses behind the first one of segments that join poses.
void append(std::vector<wend::MapPose>& poses, const wend::Segment& segment,
            const wend::Frame& frame, double cells) {
  const double count = std::max(1.0, std::ceil(std::abs(segment.length) / cells));
  for (int i = 1; i <= static_cast<int>(count); ++i) {
    poses.push_back(frame.to_metres(wend::pose_on(segment, i / count)));
  }
}

std::vector<wend::MapPose> poses_on(const wend::JoinedPoses& joined, const wend::Frame& frame,
                                    double cells) {
  std::vector<wend::MapPose> poses{frame.to_metres(joined.poses().front())};
  for (std::size_t i = 0; i < joined.segment_count(); ++i) {
    append(poses, joined.segment(i), frame, cells);
  }
  return poses;
}

std::vector<wend::MapPose> poses_on(const std::vector<wend::Arc>& lines, const wend::Frame& frame,
                                    double cells) {
  std::vector<wend::MapPose> poses{frame.to_metres(lines.front().from)};
  for (const wend::Arc& line : lines) {
    if (line.length == 0) continue;
    // At a corner the robot faces where it goes on.
    poses.back().heading = frame.to_metres(line.from).heading;
    append(poses, {line.from, line.length, line.turn(), 0}, frame, cells);
  }
  return poses;
}

bool is_free(wend::Point from, wend::Point to, const wend::FreeSpace& space,
             wend::Adjacency adjacency) {
  return !wend::first_collision(wend::Path::along({from, to}), space, adjacency);
}

bool same_cell(wend::Point a, wend::Point b) {
  return std::floor(a.x) == std::floor(b.x) && std::floor(a.y) == std::floor(b.y);
}

}  // namespace

std::vector<wend::MapPose> poses_along(const wend::Path& path, const wend::Frame& frame,
                                       double spacing) {
  const double cells = spacing / frame.resolution;
  if (path.driven()) return poses_on(wend::JoinedPoses(path.driven_poses()), frame, cells);
  const std::vector<wend::Arc> lines = path.arcs();
  if (lines.empty()) return {frame.to_metres(path.poses().front())};
  return poses_on(lines, frame, cells);
}

wend::Path with_exact_ends(const wend::Path& path, const wend::FreeSpace& space,
                           wend::Adjacency adjacency, const wend::MapPose& start,
                           const wend::MapPose& goal) {
  const wend::Frame& frame = space.map().frame();
  std::vector<wend::Point> points = path.points();
  const wend::Point from = frame.to_grid(start.point());
  const wend::Point to = frame.to_grid(goal.point());
  if (points.size() == 1) points.push_back(points.front());
  const auto replace = [&](wend::Point& end, wend::Point exact, wend::Point next) {
    if (same_cell(end, exact) && is_free(exact, next, space, adjacency)) end = exact;
  };
  replace(points.front(), from, points[1]);
  replace(points.back(), to, points[points.size() - 2]);
  if (points.size() == 2 && points.front() == points.back()) points.pop_back();
  return wend::Path::along(std::move(points));
}

}  // namespace wend_nav2
