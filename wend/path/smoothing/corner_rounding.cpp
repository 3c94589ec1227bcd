#include "wend/path/smoothing/corner_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/path/length_fault.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

constexpr double kSame = 1e-9;  // cells: rounding

/// So far from a point in a direction.
Pose displaced(Point point, double heading, double distance) {
  const auto [sine, cosine] = sine_and_cosine(heading);
  return {point.x + distance * cosine, point.y + distance * sine, heading};
}

/// Appends a pose, unless the last one is the same but for rounding.
void drive_to(std::vector<Pose>& poses, const Pose& pose) {
  const bool same = !poses.empty() && distance(poses.back().point(), pose.point()) < kSame &&
                    std::abs(poses.back().heading - pose.heading) < kSame;
  if (!same) poses.push_back(pose);
}

Path rounded(std::vector<Point> points, const FreeSpace& space, double window, Adjacency adjacency,
             DeadlineCheck& stop) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() == 1) return Path::through({displaced(points.front(), 0, 0)});
  std::vector<Pose> poses;
  double heading = Line{points[0], points[1]}.heading();
  drive_to(poses, displaced(points[0], heading, 0));
  for (std::size_t i = 2; i < points.size() && !stop.now(); ++i) {
    const Corner corner(points[i - 2], points[i - 1], points[i]);
    const Point at = points[i - 1];
    const double next = Line{at, points[i]}.heading();
    const double radius = corner.radius(window);
    const double cut =
        std::isfinite(radius) && radius > kSame ? radius * corner.half_turn_tangent() : 0;
    const Pose begin = displaced(at, heading, -cut);
    const Pose end = displaced(at, next, cut);
    if (cut > 0 && fits_along(space, arc_to(begin, end.point()), {.adjacency = adjacency})) {
      drive_to(poses, begin);
      drive_to(poses, end);
    } else {
      drive_to(poses, displaced(at, heading, 0));
      const double turn = turn_between(space, at, heading, next).angle;
      if (turn != normalized_angle(next - heading)) {  // half a turn, the other way
        drive_to(poses, displaced(at, normalized_angle(heading + turn / 2), 0));
      }
      drive_to(poses, displaced(at, next, 0));
    }
    heading = next;
  }
  drive_to(poses, displaced(points.back(), heading, 0));
  return Path::through(std::move(poses));
}

}  // namespace

Expected<Path, Error> rounded_corners(const Path& path, const FreeSpace& space, double window,
                                      Adjacency adjacency, const Deadline& deadline) {
  if (auto fault = fault_of(path, space)) return Unexpected<Error>(*std::move(fault));
  if (auto fault = fault_of_length("corner_rounding", window)) {
    return Unexpected<Error>(*std::move(fault));
  }
  DeadlineCheck stop(&deadline);
  Path curve = path.visit(
      [&](const JoinedPoses&) { return path; },
      [&](const auto&) { return rounded(path.points(), space, window, adjacency, stop); });
  if (stop.has_passed()) {
    return failure(deadline.status(), deadline.text() + ", before the path's corners were rounded");
  }
  return curve;
}

}  // namespace wend
