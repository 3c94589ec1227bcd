// follower: drives the robot along /plan_smoothed by /cmd_vel, with one of wend's controllers.
//
//   rosrun wend_ros follower _controller:=pure_pursuit
//
// It stops when the pose is lost, when /cancel says so, when an empty path comes, and at the goal; a
// path that is too old when it comes is not driven. A new path takes over while it drives. What it
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
#include <optional>
#include <string>
#include <vector>

#include "wend/control/controller.hpp"
#include "wend/control/follower.hpp"
#include "wend_ros/master_watch.hpp"
#include "wend_ros/option_parameters.hpp"
#include "wend_ros/path_message.hpp"

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
  }
  return "idle";
}

class FollowerNode {
 public:
  FollowerNode(ros::NodeHandle& node, ros::NodeHandle& own,
               std::unique_ptr<wend::Controller> controller)
      : rate_(own.param("rate", 20.0)),
        path_age_(own.param("path_age", 30.0)),
        pose_age_(own.param("pose_age", 0.5)),
        robot_frame_(own.param<std::string>("robot_frame", "base_link")),
        controller_(std::move(controller)),
        follower_(*controller_, wend_ros::options_from_parameters<wend::VelocityLimits>(own),
                  wend_ros::options_from_parameters<wend::FollowerOptions>(own)),
        listener_(buffer_),
        commands_(node.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
        states_(own.advertise<std_msgs::String>("state", 1, true)),
        paths_(node.subscribe("plan_smoothed", 1, &FollowerNode::take_path, this)),
        cancels_(node.subscribe("cancel", 1, &FollowerNode::cancel, this)),
        timer_(node.createTimer(ros::Duration(1 / rate_), &FollowerNode::step, this)) {
    say("idle");
  }

 private:
  void take_path(const nav_msgs::Path& path) {
    const double age = (ros::Time::now() - path.header.stamp).toSec();
    if (path.poses.empty()) return stop("idle");
    if (!path.header.stamp.isZero() && age > path_age_) {
      ROS_WARN_STREAM("a path that is " << age << " s old is not driven");
      return stop("idle");
    }
    std::vector<wend::Point> points;
    for (const auto& stamped : path.poses) {
      if (!wend_ros::is_finite(stamped.pose)) {
        ROS_ERROR("path rejected: a pose contains NaN or infinity");
        return stop("idle");
      }
      points.push_back({stamped.pose.position.x, stamped.pose.position.y});
    }
    frame_id_ = path.header.frame_id;
    // Metres are the grid's units here.
    follower_.follow(wend::Route(wend::Path::along(points), wend::Frame{}));
    driving_ = true;
  }

  void cancel(const std_msgs::Empty&) { stop("idle"); }

  std::optional<wend::MapPose> pose() const {
    try {
      const auto transform = buffer_.lookupTransform(frame_id_, robot_frame_, ros::Time(0));
      if ((ros::Time::now() - transform.header.stamp).toSec() > pose_age_) return std::nullopt;
      geometry_msgs::Pose pose;
      pose.position.x = transform.transform.translation.x;
      pose.position.y = transform.transform.translation.y;
      pose.orientation = transform.transform.rotation;
      return wend_ros::pose_from(pose);
    } catch (const tf2::TransformException&) {
      return std::nullopt;
    }
  }

  void step(const ros::TimerEvent&) {
    if (!driving_) return;
    const auto where = pose();
    if (!where) {
      ROS_WARN_THROTTLE(1, "the robot's pose is lost: it stops");
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
  std::unique_ptr<wend::Controller> controller_;
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

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "follower");
  ros::NodeHandle node;
  ros::NodeHandle own("~");
  const auto name = own.param<std::string>("controller", "pure_pursuit");
  const wend::ControllerInfo* info = wend::controllers().find(name);
  if (info == nullptr) {
    ROS_ERROR_STREAM(wend::controllers().unknown("controller", name));
    return 2;
  }
  auto controller = info->make(wend_ros::parameters_of(own, info->options));
  if (!controller) {
    ROS_ERROR_STREAM(controller.error().message);
    return 2;
  }
  const FollowerNode follower(node, own, *std::move(controller));
  const wend_ros::MasterWatch watch;
  ros::spin();
  return 0;
}
