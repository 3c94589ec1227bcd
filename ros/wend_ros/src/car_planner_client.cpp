// car_planner_client: asks car_planner_server for a drive on a random yard, logs the way-points, and
// shows yard and drive in rviz, in the frame `car_map`.
//
//   rosrun wend_ros car_planner_client 20 20 0 0 2 18 18 2 25 25
//
// It exits with 0 (found), 1 (no path), 2 (wrong arguments) or 3 (no server). With the parameter stay it stays until it
// is stopped, so that rviz, which may come later, gets what it shows.

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <visualization_msgs/MarkerArray.h>
#include <wend_ros/PlanCar.h>

#include <string>
#include <vector>

#include "wend/path/smoothing/simplification.hpp"
#include "wend_ros/car_client_arguments.hpp"
#include "wend_ros/car_planning.hpp"
#include "wend_ros/markers.hpp"
#include "wend_ros/path_message.hpp"

namespace {

constexpr const char* kFrame = "car_map";
constexpr double kPatience = 10;  // s, for the server

enum ExitCode : int { kFound = 0, kNoPlan = 1, kBadArguments = 2, kNoServer = 3 };

/// `map` turned by pi about x: +y points south.
geometry_msgs::TransformStamped car_map_transform() {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time::now();
  transform.header.frame_id = "map";
  transform.child_frame_id = kFrame;
  transform.transform.rotation.x = 1;
  return transform;
}

/// The command line, ours and ROS's own words apart. `yard:=FILE` looks like one of ROS's, which
/// would take the file for a name and throw.
struct CommandLine {
  CommandLine(int argc, char** argv) {
    for (int i = 0; i < argc; ++i) {
      const std::string word = argv[i];
      const bool yard = word.starts_with("yard:=");
      const bool for_ros = i == 0 || (word.find(":=") != std::string::npos && !yard);
      if (for_ros) {
        ros_words.push_back(argv[i]);
      } else if (word != "yard:=") {
        words.push_back(word);
      }
    }
  }

  std::vector<std::string> words;
  std::vector<char*> ros_words;
};

class Show {
 public:
  explicit Show(ros::NodeHandle& node)
      : markers_(node.advertise<visualization_msgs::MarkerArray>("car_markers", 4, true)),
        poses_(node.advertise<geometry_msgs::PoseArray>("car_poses", 1, true)),
        path_(node.advertise<nav_msgs::Path>("car_path", 1, true)) {
    broadcaster_.sendTransform(car_map_transform());
  }

  void yard(const wend::GridMap& yard) {
    auto markers = wend_ros::yard_markers(yard, kFrame);
    markers_.publish(markers);
  }

  void drive(const wend_ros::CarResult& result, const wend::FreeSpace& space) {
    const wend::Frame& frame = space.map().frame();
    constexpr double kSpacing = 0.1;  // cells: lines so short that arcs look like arcs
    const wend::Path drive = wend_ros::path_of(result);
    poses_.publish(wend_ros::poses_of(wend_ros::to_message(drive, frame, kFrame)));
    const auto dense = wend::resampled(drive, kSpacing, space);
    if (dense) path_.publish(wend_ros::to_message(*dense, frame, kFrame));
  }

 private:
  tf2_ros::StaticTransformBroadcaster broadcaster_;
  ros::Publisher markers_;
  ros::Publisher poses_;
  ros::Publisher path_;
};

int plan_and_show(ros::NodeHandle& node, const wend_ros::CarRequest& request, bool stays) {
  ros::ServiceClient client = node.serviceClient<wend_ros::PlanCar>("plan_car");
  if (!client.waitForExistence(ros::Duration(kPatience))) {
    ROS_ERROR("there is no service plan_car: is car_planner_server running?");
    return kNoServer;
  }
  wend_ros::PlanCar call;
  call.request.request = request;
  if (!client.call(call)) {
    ROS_ERROR("the call of plan_car failed: car_planner_server went away");
    return kNoServer;
  }
  const wend_ros::CarResult& result = call.response.result;
  Show show(node);
  if (const auto yard = wend_ros::yard_of(request)) {
    show.yard(*yard);
    show.drive(result, *wend::make_free_space(*yard));
  }
  if (result.status == 0) {
    for (const std::string& line : wend_ros::commands_of(result)) ROS_INFO_STREAM(line);
    ROS_INFO_STREAM(result.moves.size() << " moves, fuel " << result.fuel << ", "
                                        << result.metrics.expanded << " states expanded");
  } else {
    ROS_ERROR_STREAM("no drive, " << result.status << " " << result.status_name << ": "
                                  << result.reason);
  }
  if (stays) ros::spin();
  return result.status == 0 ? kFound : kNoPlan;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line(argc, argv);
  int ros_words = static_cast<int>(line.ros_words.size());
  ros::init(ros_words, line.ros_words.data(), "car_planner_client");
  ros::NodeHandle node;
  ros::NodeHandle own("~");
  const auto request =
      wend_ros::car_request(line.words, static_cast<std::uint64_t>(own.param("seed", 1)));
  if (!request) {
    ROS_ERROR_STREAM(request.error());
    return kBadArguments;
  }
  return plan_and_show(node, *request, own.param("stay", false));
}
