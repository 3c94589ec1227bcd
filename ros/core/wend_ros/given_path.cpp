#include "wend_ros/given_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "wend/control/given_route.hpp"
#include "wend/io/text.hpp"
#include "wend/path/path.hpp"

namespace wend_ros {
namespace {

/// What is wrong with a position, if anything is.
std::optional<std::string> fault_of(const GivenPose& at) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z)) {
    return "contains NaN or infinity";
  }
  if (wend::Route::can_hold(wend::MapPoint{at.x, at.y})) return std::nullopt;
  return "is farther than 1e8 m from the origin";
}

wend::Expected<wend::MapPose, std::string> pose_at(
    const GivenPose& at, const wend::Expected<double, std::string>& heading) {
  if (auto fault = fault_of(at)) return wend::Unexpected<std::string>(*std::move(fault));
  if (!heading) return wend::Unexpected<std::string>(heading.error());
  return wend::MapPose{at.x, at.y, *heading};
}

/// The poses of a path as `read` reads each of them, or which one is wrong; `name`: of the path.
template <class Read>
wend::Expected<std::vector<wend::MapPose>, wend::Error> poses_from(const GivenPath& path,
                                                                   const std::string& name,
                                                                   const Read& read) {
  std::vector<wend::MapPose> poses;
  poses.reserve(path.poses.size());
  for (const GivenStampedPose& given : path.poses) {
    if (!given.frame_id.empty() && given.frame_id != path.frame_id) {
      return wend::failure(wend::Status::unsupported_query,
                           "a pose of " + name + " is in the frame " + wend::quote(given.frame_id) +
                               ", not " + wend::quote(path.frame_id));
    }
    const auto pose = read(given.pose);
    if (!pose) {
      std::string what = "pose " + std::to_string(poses.size());
      what += " of " + name;
      what += " " + pose.error();
      return wend::failure(wend::Status::unsupported_query, std::move(what));
    }
    poses.push_back(*pose);
  }
  return poses;
}

wend::Expected<wend::MapPose, std::string> as_it_is(const GivenPose& pose) {
  return pose_from(pose);
}

wend::Unexpected<wend::Error> no_poses() {
  return wend::failure(wend::Status::unsupported_query, "the path has no poses");
}

}  // namespace

double seconds_between(const GivenTime& from, const GivenTime& to) {
  return static_cast<double>(to.sec) - static_cast<double>(from.sec) +
         1e-9 * (static_cast<double>(to.nsec) - static_cast<double>(from.nsec));
}

wend::Expected<wend::MapPose, std::string> pose_from(const GivenPose& given) {
  return pose_at(given, heading_of(given.orientation));
}

wend::Expected<wend::MapPose, std::string> moved_pose_from(const GivenPose& given) {
  return pose_at(given, heading_of_frame(given.orientation));
}

wend::Expected<wend::Trajectory, wend::Error> trajectory_from(const GivenPath& path) {
  auto poses = poses_from(path, "the trajectory", as_it_is);
  if (!poses) return wend::Unexpected<wend::Error>(std::move(poses.error()));
  std::vector<wend::TimedPose> timed;
  timed.reserve(poses->size());
  for (std::size_t i = 0; i < poses->size(); ++i) {
    timed.push_back({seconds_between(path.poses.front().stamp, path.poses[i].stamp), (*poses)[i]});
  }
  return wend::Trajectory::through(timed);
}

wend::Expected<wend::Route, wend::Error> route_through(const GivenPath& path) {
  const auto poses = poses_from(path, "the path", as_it_is);
  if (!poses) return wend::Unexpected<wend::Error>(poses.error());
  if (poses->empty()) return no_poses();
  std::vector<wend::Pose> places;
  for (const wend::MapPose& pose : *poses) places.push_back({pose.x, pose.y, pose.heading});
  return wend::Route(wend::Path::through(std::move(places)), wend::Frame{});
}

wend::Expected<wend::Route, wend::Error> route_from(const GivenPath& path) {
  const bool has_headings =
      std::any_of(path.poses.begin(), path.poses.end(),
                  [](const GivenStampedPose& given) { return !is_unset(given.pose.orientation); });
  const auto poses = poses_from(path, "the path", [&](GivenPose pose) {
    if (!has_headings) pose.orientation.w = 1;
    return pose_from(pose);
  });
  if (!poses) return wend::Unexpected<wend::Error>(poses.error());
  if (has_headings || poses->empty()) return wend::given_route(*poses);
  std::vector<wend::Point> points;
  for (const wend::MapPose& pose : *poses) points.push_back({pose.x, pose.y});
  return wend::Route(wend::Path::along(std::move(points)), wend::Frame{});
}

}  // namespace wend_ros
