#include "wend_ros/robot_pose.hpp"

#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <cmath>
#include <cstddef>

#include "wend/control/route.hpp"
#include "wend/io/text.hpp"
#include "wend_ros/pose_message.hpp"

namespace wend_ros {
namespace {

/// A robot whose tf is older than this is somewhere else by now.
constexpr double kStale = 2;

/// Of what tf says about names of frames, bytes.
constexpr std::size_t kLongestReason = 300;

std::optional<wend::MapPose> start_parameter(ros::NodeHandle& own) {
  wend::MapPose pose;
  if (!own.getParam("startx", pose.x) || !own.getParam("starty", pose.y)) return std::nullopt;
  own.getParam("startyaw", pose.heading);
  if (wend::Route::can_hold(pose.point()) && std::isfinite(pose.heading)) return pose;
  ROS_ERROR(
      "~startx, ~starty and ~startyaw must be finite, and no farther than 1e8 m from the origin");
  return std::nullopt;
}

wend::Unexpected<std::string> wrong(std::string what) {
  return wend::Unexpected<std::string>(std::move(what));
}

}  // namespace

RobotPose::RobotPose(ros::NodeHandle& node, ros::NodeHandle& own)
    : robot_frame_(own.param<std::string>("robot_frame", "base_link")),
      parameter_(start_parameter(own)),
      listener_(buffer_),
      subscriber_(node.subscribe("initialpose", 1, &RobotPose::take, this)) {}

void RobotPose::take(const geometry_msgs::PoseWithCovarianceStamped& message) {
  if (const auto pose = pose_from(message.pose.pose); !pose) {
    ROS_WARN_STREAM("initialpose ignored: the pose " << pose.error());
    return;
  }
  const std::lock_guard lock(mutex_);
  initial_.emplace();
  initial_->header = message.header;
  initial_->pose = message.pose.pose;
}

wend::Expected<wend::MapPose, std::string> RobotPose::in(
    const std::string& frame_id, const geometry_msgs::PoseStamped& pose) const {
  auto given = pose_from(pose.pose);
  if (!given) return wrong("the pose " + given.error());
  if (pose.header.frame_id.empty() || pose.header.frame_id == frame_id) return given;
  try {
    geometry_msgs::PoseStamped moved;
    const auto transform = buffer_.lookupTransform(frame_id, pose.header.frame_id, ros::Time(0));
    tf2::doTransform(pose, moved, transform);
    auto there = moved_pose_from(moved.pose);
    if (!there) return wrong("the pose, taken to " + wend::quote(frame_id) + ", " + there.error());
    return there;
  } catch (const tf2::TransformException& error) {
    return wrong("the frame " + wend::quote(pose.header.frame_id) + " cannot be taken to " +
                 wend::quote(frame_id) + ": " + wend::text_line(error.what(), kLongestReason));
  }
}

wend::Expected<wend::MapPose, std::string> RobotPose::in(const std::string& frame_id) const {
  try {
    const auto transform = buffer_.lookupTransform(frame_id, robot_frame_, ros::Time(0));
    const bool is_static = transform.header.stamp.isZero();
    const bool fresh = (ros::Time::now() - transform.header.stamp).toSec() < kStale;
    if (is_static || fresh) {
      auto pose = pose_from(transform.transform);
      if (!pose) return wrong("the robot's transform " + pose.error());
      return pose;
    }
  } catch (const tf2::TransformException&) {
    // Then it is known from elsewhere, or not at all.
  }
  std::optional<geometry_msgs::PoseStamped> initial;
  {
    const std::lock_guard lock(mutex_);
    initial = initial_;
  }
  if (initial) return in(frame_id, *initial);
  if (parameter_) return *parameter_;
  return wrong("robot pose unknown: no transform from " + wend::quote(frame_id) + " to " +
               wend::quote(robot_frame_) + ", no /initialpose, no parameters ~startx and ~starty");
}

}  // namespace wend_ros
