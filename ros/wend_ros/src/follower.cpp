// follower: drives the robot by /cmd_vel, along /plan_smoothed with one of wend's controllers, or so that it
// tracks /trajectory.
//
//   rosrun wend_ros follower _controller:=pure_pursuit _robot_radius:=0.25
//   rosrun wend_ros follower _controller:=trajectory
//
// It stops at the goal, when /cancel says so, and when an empty or invalid path comes; a path that is too old when it
// comes is not driven, nor one that it cannot reach along a free line. A new path takes over while it drives.
//
// It brakes, and drives on when that has passed, while the path ahead is blocked on the newest map, and while its pose,
// the planner or a map that changes regularly are silent. What it is doing it says on ~state: "driving", "reached",
// "stuck", "off_path", "idle", "refused", "invalid"; "no_pose", "no_planner", "no_map", "blocked".
//
// Parameters: controller, and the options of the controller, of the follower (acceptance_radius,
// goal_tolerance, ...) and of the limits (speed, turn_rate, ...) by their names; rate (Hz), path_age
// (s), pose_age (s), robot_frame; planner_timeout, map_timeout; check_path, and what the check needs (map_guard.hpp).

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <wend_ros/PlannerAlive.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/control/controller.hpp"
#include "wend/control/follower.hpp"
#include "wend/control/joining.hpp"
#include "wend/control/trajectory_tracker.hpp"
#include "wend_ros/map_guard.hpp"
#include "wend_ros/master_watch.hpp"
#include "wend_ros/option_parameters.hpp"
#include "wend_ros/path_message.hpp"
#include "wend_ros/silence_watch.hpp"
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

/// Seconds of a clock that never goes back.
double steady_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Why a robot that has a path does not drive on.
struct Halt {
  std::string state;
  std::string reason;
};

wend::Unexpected<Halt> halt(std::string state, std::string reason) {
  return wend::Unexpected<Halt>({std::move(state), std::move(reason)});
}

class FollowerNode {
 public:
  FollowerNode(ros::NodeHandle& node, ros::NodeHandle& own, Steering steering)
      : rate_(wend_ros::positive_parameter(own, "rate", 20)),
        path_age_(wend_ros::positive_parameter(own, "path_age", 30)),
        pose_age_(wend_ros::positive_parameter(own, "pose_age", 0.5)),
        robot_frame_(own.param<std::string>("robot_frame", "base_link")),
        limits_(wend_ros::options_from_parameters<wend::VelocityLimits>(own)),
        steering_(std::move(steering)),
        options_(wend_ros::options_from_parameters<wend::FollowerOptions>(own)),
        follower_(*steering_.controller, limits_, options_),
        silence_(wend_ros::options_from_parameters<wend_ros::SilenceLimits>(own)),
        listener_(buffer_),
        commands_(node.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
        states_(own.advertise<std_msgs::String>("state", 1, true)) {
    if (own.param("check_path", true)) {
      guard_ = std::make_unique<wend_ros::MapGuard>(own, limits_, 1 / rate_);
    }
    subscribers_ = {steering_.tracker != nullptr
                        ? node.subscribe("trajectory", 1, &FollowerNode::take_trajectory, this)
                        : node.subscribe("plan_smoothed", 1, &FollowerNode::take_path, this),
                    node.subscribe("cancel", 1, &FollowerNode::cancel, this),
                    node.subscribe("planner_alive", 1, &FollowerNode::hear_planner, this)};
    timer_ = node.createTimer(ros::Duration(1 / rate_), &FollowerNode::step, this);
    say("idle");
  }

 private:
  void take_path(const nav_msgs::Path& message) {
    if (!is_fresh(message)) return stop("idle");
    auto route = wend_ros::route_from(message);
    if (!route) {
      ROS_ERROR_STREAM("path rejected: " << route.error().message);
      return stop("idle");
    }
    follow(*std::move(route), message.header);
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
    wend::Route route = *wend_ros::route_through(message);
    const double duration = trajectory->duration();
    const bool same_frame = message.header.frame_id == frame_id_;
    if (driving_ && same_frame && duration == duration_ && same_route(route, route_)) return;
    duration_ = duration;
    steering_.tracker->track(*std::move(trajectory));
    follow(std::move(route), message.header);
  }

  /// False for an empty path, which says that there is none any more, and for one that is too old.
  bool is_fresh(const nav_msgs::Path& path) const {
    if (path.poses.empty()) return false;
    const double age = wend_ros::seconds_between(path.header.stamp, ros::Time::now());
    if (path.header.stamp.isZero() || age <= path_age_) return true;
    ROS_WARN_STREAM("a path that is " << age << " s old is not driven");
    return false;
  }

  /// It begins at the next step, when it is known where the robot and the obstacles are.
  void follow(wend::Route route, const std_msgs::Header& header) {
    if (header.frame_id != frame_id_) forget_path();  // the same numbers are another path there
    frame_id_ = header.frame_id;
    path_stamp_ = header.stamp.isZero() ? ros::Time::now() : header.stamp;
    route_ = std::move(route);
    begins_ = true;
    driving_ = true;
  }

  void cancel(const std_msgs::Empty&) { stop("idle"); }

  /// A planner that was started later does not know the path: nobody would change it.
  void hear_planner(const wend_ros::PlannerAlive& sign) {
    silence_.hear_planner(steady_now());
    if (!driving_ || sign.began <= path_stamp_) return;
    ROS_WARN("the planner was started anew: its old path is not driven any more");
    stop("idle");
  }

  /// Where a frame lies in another one, or why that is unknown.
  wend::Expected<wend::MapPose, std::string> lookup(const std::string& in, const std::string& frame,
                                                    double most_age) const {
    try {
      const auto transform = buffer_.lookupTransform(in, frame, ros::Time(0));
      const ros::Time& stamp = transform.header.stamp;
      const double age = wend_ros::seconds_between(stamp, ros::Time::now());
      if (age > most_age && !stamp.isZero()) {
        return wend::Unexpected<std::string>("the last transform is " + std::to_string(age) +
                                             " s old");
      }
      return wend_ros::pose_from(transform.transform);
    } catch (const tf2::TransformException& fault) {
      return wend::Unexpected<std::string>(fault.what());
    }
  }

  void step(const ros::TimerEvent&) {
    if (!driving_) return;
    const auto where = may_drive();
    if (!driving_) return;  // the path is refused
    if (!where) return brake(where.error());
    follower_.set_velocity(velocity_);
    joins_at_.reset();
    const wend::FollowerStep step = follower_.step(*where, 1 / rate_);
    if (step.state != wend::FollowerState::driving) {
      ROS_INFO_STREAM("follower: " << text_of(step.state));
      return stop(text_of(step.state));
    }
    command(step.command);
    say("driving");
  }

  /// The robot's pose if it may drive on, or why it may not.
  wend::Expected<wend::MapPose, Halt> may_drive() {
    const auto where = lookup(frame_id_, robot_frame_, pose_age_);
    if (!where) return halt("no_pose", "robot pose unknown: " + where.error());
    const double now = steady_now();
    if (silence_.silent(now) == wend_ros::Silent::planner) {
      return halt("no_planner", "the planner is silent: no message of planner_alive");
    }
    if (!guard_) {
      begin(*where);
      return *where;
    }
    const auto map = guard_->now();
    if (!map) return halt("no_map", map.error().message);
    silence_.hear_map(std::chrono::duration<double>(map->heard.time_since_epoch()).count());
    if (silence_.silent(now) == wend_ros::Silent::map) return halt("no_map", "the map is silent");
    const auto lies = lies_in(map->view.frame_id);
    if (!lies) return halt("no_pose", lies.error());
    if (!begin(*where)) return *where;
    const auto blocked = guard_->path().why_blocked(
        {map->view.space, *lies}, route_, joins_at_ ? joins_at_->leg : follower_.leg(),
        joins_at_ ? joins_at_->along : follower_.along_leg());
    if (blocked) return halt("blocked", *blocked);
    return *where;
  }

  /// The newest map, and where the path's frame lies in it; nothing if either is unknown.
  std::optional<std::pair<wend::FreeSpace, wend::MapPose>> guarded_space() const {
    const auto map = guard_->now();
    if (!map) return std::nullopt;
    const auto lies = lies_in(map->view.frame_id);
    if (!lies) return std::nullopt;
    return std::pair{map->view.space, *lies};
  }

  /// Where the path's frame lies in that of the map.
  wend::Expected<wend::MapPose, std::string> lies_in(const std::string& map_frame) const {
    if (map_frame == frame_id_) return wend::MapPose{};
    return lookup(map_frame, frame_id_, pose_age_);
  }

  /// Begins with a path that has come; false if it is refused.
  bool begin(const wend::MapPose& where) {
    if (!begins_) return true;
    begins_ = false;
    wend::FreeLine can_reach;
    if (guard_) {
      can_reach = [this](const wend::MapPose& from, wend::MapPoint to) {
        const auto space = guarded_space();
        return space && guard_->path().can_reach({space->first, space->second}, from.point(), to);
      };
    }
    const wend::JoiningOptions joining{
        .within = options_.off_path, .tie = options_.acceptance_radius, .can_reach = can_reach};
    const auto place = place_to_join(route_, where, joining);
    if (!place && can_reach && !can_reach(where, route_.start().point())) {
      ROS_ERROR("path rejected: the straight line from the robot to it is not free");
      stop("refused");
      return false;
    }
    joins_at_ = place.value_or(wend::OnRoute{});
    follower_.follow(route_, std::move(can_reach));
    return true;
  }

  /// As fast as the limits allow.
  void brake(const Halt& halt) {
    ROS_WARN_STREAM_THROTTLE(1, "it brakes: " << halt.reason);
    command(limited({}, velocity_, limits_, 1 / rate_));
    say(halt.state);
  }

  /// When the same path comes again, it is another drive, which may begin elsewhere.
  void forget_path() { follower_ = wend::Follower(*steering_.controller, limits_, options_); }

  void stop(const std::string& state) {
    driving_ = begins_ = false;
    forget_path();
    command({});
    say(state);
  }

  void command(const wend::Velocity& velocity) {
    velocity_ = velocity;
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
  wend::FollowerOptions options_;
  wend::Follower follower_;
  wend_ros::SilenceWatch silence_;
  std::unique_ptr<wend_ros::MapGuard> guard_;  // null: paths are not tested
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  ros::Publisher commands_;
  ros::Publisher states_;

  bool driving_ = false;                   // along route_, or waits until it may
  bool begins_ = false;                    // with a path that has just come
  std::optional<wend::OnRoute> joins_at_;  // until the first step along it
  wend::Route route_{std::vector{wend::RouteLeg{wend::MapPolyline({wend::MapPoint{}})}}};
  std::string frame_id_;     // of the path
  ros::Time path_stamp_;     // when it was made
  double duration_ = 0;      // of the trajectory, s
  wend::Velocity velocity_;  // as last commanded
  std::string said_;

  ros::Timer timer_;
  std::vector<ros::Subscriber> subscribers_;  // last: they use the others
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
  FollowerNode follower(node, own, *std::move(steering));
  const wend_ros::MasterWatch watch;
  ros::spin();
  return 0;
}
