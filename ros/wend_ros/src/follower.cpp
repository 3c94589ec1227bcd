// follower: drives the robot by /cmd_vel, along /plan_smoothed with one of wend's controllers, or so that it
// tracks /trajectory.
//
//   rosrun wend_ros follower _controller:=pure_pursuit
//   rosrun wend_ros follower _controller:=trajectory
//
// It stops when the pose is lost, when /cancel says so, when an empty or invalid path comes, and at the
// goal; a path that is too old when it comes is not driven. A new path takes over while it drives. What it
// is doing it says on ~state: "driving", "reached", "stuck", "off_path", "idle", "no_pose".
//
// Parameters: controller, and the options of the controller, of the follower (acceptance_radius,
// goal_tolerance, ...) and of the limits (speed, turn_rate, ...) by their names; rate (Hz), path_age
// (s), pose_age (s), robot_frame.

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/control/controller.hpp"
#include "wend/control/follower.hpp"
#include "wend/control/trajectory_tracker.hpp"
#include "wend_ros/master_watch.hpp"
#include "wend_ros/option_parameters.hpp"
#include "wend_ros/path_message.hpp"
#include "wend_ros/tracking.hpp"

namespace {

std::string text_of(wend::FollowerState state) {
  switch (state) {
    case wend::FollowerState::driving:
      return "driving";
    case wend::FollowerState::reached:
      return "reached";
    case wend::FollowerState::stuck:
      return "stuck";
    case wend::FollowerState::off_path:
      return "off_path";
    case wend::FollowerState::invalid:
      return "invalid";
  }
  return "idle";
}

/// A controller, and the same as a tracker if it is one.
struct Steering {
  std::unique_ptr<wend::Controller> controller;
  wend::TrajectoryTracker* tracker = nullptr;
};

/// The name of the tracker, which is not in the registry: it needs a trajectory.
constexpr std::string_view kTracker = "trajectory";

/// A trajectory ends with a heading.
wend::FollowerOptions follower_options(const ros::NodeHandle& own, bool tracks) {
  constexpr double kHeadingTolerance = 0.1;  // rad
  auto options = wend_ros::options_from_parameters<wend::FollowerOptions>(own);
  if (tracks && !own.hasParam("heading_tolerance")) options.heading_tolerance = kHeadingTolerance;
  return options;
}

class FollowerNode {
 public:
  FollowerNode(ros::NodeHandle& node, ros::NodeHandle& own, Steering steering)
      : rate_(own.param("rate", 20.0)),
        path_age_(own.param("path_age", 30.0)),
        pose_age_(own.param("pose_age", 0.5)),
        robot_frame_(own.param<std::string>("robot_frame", "base_link")),
        limits_(wend_ros::options_from_parameters<wend::VelocityLimits>(own)),
        steering_(std::move(steering)),
        follower_(*steering_.controller, limits_,
                  follower_options(own, steering_.tracker != nullptr)),
        listener_(buffer_),
        commands_(node.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
        states_(own.advertise<std_msgs::String>("state", 1, true)),
        paths_(steering_.tracker != nullptr
                   ? node.subscribe("trajectory", 1, &FollowerNode::take_trajectory, this)
                   : node.subscribe("plan_smoothed", 1, &FollowerNode::take_path, this)),
        cancels_(node.subscribe("cancel", 1, &FollowerNode::cancel, this)),
        timer_(node.createTimer(ros::Duration(1 / rate_), &FollowerNode::step, this)) {
    say("idle");
  }

 private:
  void take_path(const nav_msgs::Path& path) {
    if (!is_fresh(path)) return stop("idle");
    std::vector<wend::Point> points;
    for (const auto& stamped : path.poses) {
      if (!wend_ros::is_finite(stamped.pose)) {
        ROS_ERROR("path rejected: a pose contains NaN or infinity");
        return stop("idle");
      }
      points.push_back({stamped.pose.position.x, stamped.pose.position.y});
    }
    follow(wend::Path::along(points), path.header.frame_id);
  }

  /// Its time begins now, whatever the stamps count from.
  void take_trajectory(const nav_msgs::Path& message) {
    if (!is_fresh(message)) return stop("idle");
    auto trajectory = wend_ros::trajectory_from(message);
    const std::string fault =
        trajectory ? wend_ros::why_untrackable(*trajectory, limits_) : trajectory.error().message;
    if (!fault.empty()) {
      ROS_ERROR_STREAM("trajectory rejected: " << fault);
      return stop("idle");
    }
    steering_.tracker->track(*std::move(trajectory));
    follow(wend_ros::path_through(message), message.header.frame_id);
  }

  /// False for an empty path, which says that there is none any more, and for one that is too old.
  bool is_fresh(const nav_msgs::Path& path) const {
    if (path.poses.empty()) return false;
    const double age = wend_ros::seconds_between(path.header.stamp, ros::Time::now());
    if (path.header.stamp.isZero() || age <= path_age_) return true;
    ROS_WARN_STREAM("a path that is " << age << " s old is not driven");
    return false;
  }

  /// A path in metres, which are the grid's units here.
  void follow(const wend::Path& path, const std::string& frame_id) {
    frame_id_ = frame_id;
    follower_.follow(wend::Route(path, wend::Frame{}));
    driving_ = true;
  }

  void cancel(const std_msgs::Empty&) { stop("idle"); }

  /// Where the robot is in the path's frame, or why that is unknown.
  wend::Expected<wend::MapPose, std::string> pose() const {
    try {
      const auto transform = buffer_.lookupTransform(frame_id_, robot_frame_, ros::Time(0));
      const double age = wend_ros::seconds_between(transform.header.stamp, ros::Time::now());
      if (age > pose_age_) {
        return wend::Unexpected<std::string>("the last transform is " + std::to_string(age) +
                                             " s old");
      }
      geometry_msgs::Pose pose;
      pose.position.x = transform.transform.translation.x;
      pose.position.y = transform.transform.translation.y;
      pose.orientation = transform.transform.rotation;
      return wend_ros::pose_from(pose);
    } catch (const tf2::TransformException& fault) {
      return wend::Unexpected<std::string>(fault.what());
    }
  }

  void step(const ros::TimerEvent&) {
    if (!driving_) return;
    const auto where = pose();
    if (!where) {
      ROS_WARN_STREAM_THROTTLE(1, "robot pose unknown, it stops: " << where.error());
      command({});
      return say("no_pose");
    }
    const wend::FollowerStep step = follower_.step(*where, 1 / rate_);
    if (step.state != wend::FollowerState::driving) {
      ROS_INFO_STREAM("follower: " << text_of(step.state));
      return stop(text_of(step.state));
    }
    command(step.command);
    say("driving");
  }

  void stop(const std::string& state) {
    driving_ = false;
    command({});
    say(state);
  }

  void command(const wend::Velocity& velocity) const {
    geometry_msgs::Twist twist;
    twist.linear.x = velocity.linear;
    twist.angular.z = velocity.angular;
    commands_.publish(twist);
  }

  void say(const std::string& state) {
    if (state == said_) return;
    said_ = state;
    std_msgs::String message;
    message.data = state;
    states_.publish(message);
  }

  double rate_;
  double path_age_;
  double pose_age_;
  std::string robot_frame_;
  wend::VelocityLimits limits_;
  Steering steering_;
  wend::Follower follower_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  ros::Publisher commands_;
  ros::Publisher states_;
  ros::Subscriber paths_;
  ros::Subscriber cancels_;
  ros::Timer timer_;
  bool driving_ = false;
  std::string frame_id_;
  std::string said_;
};

/// The controller of the parameters, or why there is none.
wend::Expected<Steering, std::string> steering_of(const ros::NodeHandle& own) {
  const auto name = own.param<std::string>("controller", "pure_pursuit");
  if (name == kTracker) {
    auto tracker = std::make_unique<wend::TrajectoryTracker>(
        wend::Trajectory(), wend_ros::options_from_parameters<wend::TrackingGains>(own));
    wend::TrajectoryTracker* const pointer = tracker.get();
    return Steering{std::move(tracker), pointer};
  }
  const wend::ControllerInfo* info = wend::controllers().find(name);
  if (info == nullptr) {
    auto names = wend::controllers().names();
    names.emplace_back(kTracker);
    return wend::Unexpected<std::string>(wend::unknown_name("controller", name, names));
  }
  auto controller = info->make(wend_ros::parameters_of(own, info->options));
  if (!controller) return wend::Unexpected<std::string>(controller.error().message);
  return Steering{*std::move(controller)};
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "follower");
  ros::NodeHandle node;
  ros::NodeHandle own("~");
  auto steering = steering_of(own);
  if (!steering) {
    ROS_FATAL_STREAM(steering.error());
    return 2;
  }
  const FollowerNode follower(node, own, *std::move(steering));
  const wend_ros::MasterWatch watch;
  ros::spin();
  return 0;
}
