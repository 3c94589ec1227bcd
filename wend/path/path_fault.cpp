#include "wend/path/path_fault.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "wend/base/parse.hpp"
#include "wend/geometry/frame.hpp"

namespace wend {
namespace {

bool is_finite(const Pose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

bool is_usable(const Pose& pose) {
  return is_exact(pose.point()) && std::abs(pose.heading) <= kLargestHeading;
}

/// Calls visit(pose) for each point until it returns false; waypoints and cells have the heading 0. How often it
/// returned true.
template <class Visit>
std::size_t count_while(const Path& path, const Visit& visit) {
  const auto count = [&visit](const auto& joints, const auto& pose_of) {
    const auto end = std::ranges::find_if_not(joints, visit, pose_of);
    return static_cast<std::size_t>(end - joints.begin());
  };
  return path.visit(
      [&](std::span<const Cell> cells) {
        return count(cells, [](Cell cell) { return pose_at(cell); });
      },
      [&](std::span<const Point> points) {
        return count(points, [](Point point) { return Pose{point.x, point.y, 0}; });
      },
      [&](const JoinedPoses& drive) {
        return count(drive.poses(), [](const Pose& pose) { return pose; });
      });
}

Pose pose_number(const Path& path, std::size_t i) {
  if (path.driven()) return path.driven_poses()[i];
  const Point point = path.cells().empty() ? path.waypoints()[i] : centre_of(path.cells()[i]);
  return {point.x, point.y, 0};
}

/// "point 3 of the path, (1,nan) m"
std::string text_of(const Pose& pose, std::size_t i, const Frame* frame) {
  const bool metric = frame != nullptr && frame->metric;
  const MapPoint at = metric ? frame->to_metres(pose.point()) : MapPoint{pose.x, pose.y};
  return "point " + std::to_string(i) + " of the path, (" + format_number(at.x) + ',' +
         format_number(at.y) + (metric ? ") m," : "),");
}

Error fault_at(const Path& path, std::size_t i, const std::string& what, const Frame* frame) {
  return {Status::unsupported_query, text_of(pose_number(path, i), i, frame) + ' ' + what,
          "point " + std::to_string(i)};
}

std::optional<Error> fault_in(const Path& path, const Frame* frame) {
  if (path.empty()) return Error{Status::unsupported_query, "the path is empty", {}};
  const std::size_t good = points_without_fault(path);
  if (good == path.size()) return std::nullopt;
  const Pose pose = pose_number(path, good);
  if (!is_finite(pose)) return fault_at(path, good, "contains NaN or infinity", frame);
  if (std::abs(pose.heading) > kLargestHeading) {
    return fault_at(path, good,
                    "has the heading " + format_number(pose.heading) + ": at most " +
                        format_number(kLargestHeading) + " rad expected",
                    frame);
  }
  return fault_at(path, good,
                  "is too far away: at most " + format_number(kFarthestPoint) +
                      " cells from the origin of the grid expected",
                  frame);
}

}  // namespace

std::size_t points_without_fault(const Path& path) { return count_while(path, is_usable); }

std::optional<Error> fault_of(const Path& path) { return fault_in(path, nullptr); }

std::optional<Error> fault_of(const Path& path, const FreeSpace& space) {
  const Frame& frame = space.map().frame();
  if (auto fault = fault_in(path, &frame)) return fault;
  const std::size_t good =
      count_while(path, [&](const Pose& pose) { return near_map(space, pose); });
  if (good == path.size()) return std::nullopt;
  return fault_at(path, good,
                  "is too far off the map: at most " + format_number(kFarthestOffMap) +
                      " cells off its " + std::to_string(space.width()) + " x " +
                      std::to_string(space.height()) + " cells expected",
                  &frame);
}

}  // namespace wend
