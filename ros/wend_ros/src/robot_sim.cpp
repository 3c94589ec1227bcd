// robot_sim: a differential-drive robot. /cmd_vel moves it, /odom and tf say where it is, and
// /initialpose puts it somewhere. It drives through walls: what it does not see, it cannot mind.
//
//   rosrun wend_ros robot_sim _startx:=1 _starty:=1
//   rosrun wend_ros robot_sim _startx:=1 _starty:=1 _map:=office.yaml _sensor_range:=5
//
// Parameters: startx, starty, startyaw; rate (Hz); actuation_noise, position_noise, heading_noise and
// seed as in wend's simulation; speed, turn_rate, acceleration, turn_acceleration.
//
// With the parameter map, a file, it discovers that map with a laser scanner that looks all around and sees
// sensor_range (m) far, sensor_rate (Hz) times a second: what it knows is /map and /map_updates. At first that
// is nothing, or the map of the parameter known, a file. Obstacles that it discovers still do not stop it.

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "wend/base/expected.hpp"
#include "wend/base/random.hpp"
#include "wend/control/motion_model.hpp"
#include "wend/control/route.hpp"
#include "wend/control/simulation.hpp"
#include "wend_ros/map_sensor.hpp"
#include "wend_ros/master_watch.hpp"
#include "wend_ros/option_parameters.hpp"
#include "wend_ros/pose_message.hpp"

namespace {

constexpr double kCommandTimeout = 0.5;  // s: a robot without commands stops

geometry_msgs::TransformStamped transform_of(const wend::MapPose& pose, const std::string& from,
                                             const std::string& to) {
  const geometry_msgs::Pose message = wend_ros::to_message(pose);
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time::now();
  transform.header.frame_id = from;
  transform.child_frame_id = to;
  transform.transform.translation.x = message.position.x;
  transform.transform.translation.y = message.position.y;
  transform.transform.rotation = message.orientation;
  return transform;
}

class RobotSim {
 public:
  RobotSim(ros::NodeHandle& node, ros::NodeHandle& own, const wend::MapPose& start)
      : model_(wend_ros::options_from_parameters<wend::MotionModel>(own)),
        noise_(wend_ros::options_from_parameters<wend::SimulationOptions>(own)),
        random_(static_cast<std::uint64_t>(noise_.seed)),
        odometry_(node.advertise<nav_msgs::Odometry>("odom", 10)),
        commands_(node.subscribe("cmd_vel", 1, &RobotSim::take_command, this)),
        placings_(node.subscribe("initialpose", 1, &RobotSim::place, this)) {
    state_.pose = start;
    // It knows where it is on the map: odometry's frame is the map's.
    fixed_.sendTransform(transform_of({}, "map", "odom"));
    timer_ = node.createTimer(ros::Duration(1 / noise_.rate), &RobotSim::step, this);
  }

  /// Discovers a map, `range` metres around it, so many times a second.
  void discover(ros::NodeHandle& node, wend_ros::SensedMap map, double range, double rate) {
    sensor_ = std::make_unique<wend_ros::MapSensor>(node, std::move(map), range);
    sensor_timer_ = node.createTimer(ros::Duration(1 / rate), &RobotSim::look, this);
  }

 private:
  void take_command(const geometry_msgs::Twist& twist) {
    if (!std::isfinite(twist.linear.x + twist.angular.z)) {
      ROS_WARN_THROTTLE(1, "cmd_vel ignored: the velocity contains NaN or infinity");
      return;
    }
    wanted_ = {twist.linear.x, twist.angular.z};
    commanded_ = ros::Time::now();
  }

  void place(const geometry_msgs::PoseWithCovarianceStamped& message) {
    const auto pose = wend_ros::pose_from(message.pose.pose);
    if (!pose) {
      ROS_WARN_STREAM("initialpose ignored: the pose " << pose.error());
      return;
    }
    if (!message.header.frame_id.empty() && message.header.frame_id != "map") {
      ROS_WARN_STREAM("initialpose: in the frame '" << message.header.frame_id << "', not 'map'");
      return;
    }
    state_ = {*pose};
    wanted_ = {};
  }

  void step(const ros::TimerEvent& event) {
    const double seconds = 1 / noise_.rate;
    if ((event.current_real - commanded_).toSec() > kCommandTimeout) wanted_ = {};
    const wend::Velocity slipping{
        wanted_.linear * (1 + noise_.actuation_noise * random_.gaussian()),
        wanted_.angular * (1 + noise_.actuation_noise * random_.gaussian())};
    state_ = wend::drive(model_, state_, slipping, seconds).to;
    publish();
  }

  void look(const ros::TimerEvent&) { sensor_->look(state_.pose); }

  void publish() {
    const wend::MapPose measured{state_.pose.x + noise_.position_noise * random_.gaussian(),
                                 state_.pose.y + noise_.position_noise * random_.gaussian(),
                                 state_.pose.heading + noise_.heading_noise * random_.gaussian()};
    nav_msgs::Odometry message;
    message.header.stamp = ros::Time::now();
    message.header.frame_id = "odom";
    message.child_frame_id = "base_link";
    message.pose.pose = wend_ros::to_message(measured);
    message.twist.twist.linear.x = state_.velocity.linear;
    message.twist.twist.angular.z = state_.velocity.angular;
    odometry_.publish(message);
    moving_.sendTransform(transform_of(measured, "odom", "base_link"));
  }

  wend::MotionModel model_;
  wend::SimulationOptions noise_;
  wend::Random random_;
  wend::RobotState state_;
  wend::Velocity wanted_;
  ros::Time commanded_;
  ros::Publisher odometry_;
  ros::Subscriber commands_;
  ros::Subscriber placings_;
  tf2_ros::StaticTransformBroadcaster fixed_;
  tf2_ros::TransformBroadcaster moving_;
  ros::Timer timer_;
  std::unique_ptr<wend_ros::MapSensor> sensor_;  // null: it discovers nothing
  ros::Timer sensor_timer_;
};

/// Where the parameters say that it stands at first, or what is wrong with them.
wend::Expected<wend::MapPose, std::string> start_of(const ros::NodeHandle& own) {
  const wend::MapPose start{own.param("startx", 0.0), own.param("starty", 0.0),
                            own.param("startyaw", 0.0)};
  if (wend::Route::can_hold(start.point()) && std::isfinite(start.heading)) return start;
  return wend::Unexpected<std::string>(
      "~startx, ~starty and ~startyaw must be finite, and no farther than 1e8 m from the origin");
}

/// What is wrong with the map to discover, empty if nothing is.
std::string discover_map(RobotSim& robot, ros::NodeHandle& node, const ros::NodeHandle& own) {
  constexpr double kRange = 5;  // m
  constexpr double kRate = 10;  // Hz
  if (own.param<std::string>("map", "").empty()) return {};
  auto map = wend_ros::sensed_map_of(own);
  if (!map) return map.error();
  robot.discover(node, *std::move(map), wend_ros::positive_parameter(own, "sensor_range", kRange),
                 wend_ros::positive_parameter(own, "sensor_rate", kRate));
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "robot_sim");
  ros::NodeHandle node;
  ros::NodeHandle own("~");
  const auto start = start_of(own);
  if (!start) {
    ROS_FATAL_STREAM(start.error());
    return 2;
  }
  RobotSim robot(node, own, *start);
  if (const std::string fault = discover_map(robot, node, own); !fault.empty()) {
    ROS_FATAL_STREAM(fault);
    return 2;
  }
  const wend_ros::MasterWatch watch;
  ros::spin();
  return 0;
}
