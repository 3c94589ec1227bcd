// planner_server: wend's planners as a node; see planner_node.hpp and docs/ros.md.

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <string>

#include "wend_ros/master_watch.hpp"
#include "wend_ros/planner_node.hpp"
#include "wend_ros/plugins.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "planner_server");
  ros::NodeHandle node;
  ros::NodeHandle own("~");
  if (const std::string fault = wend_ros::load_plugins(own); !fault.empty()) {
    ROS_FATAL_STREAM(fault);
    return 2;
  }
  // A service call that plans holds a thread: so services have a queue of their own, and topics go on
  // however many clients there are.
  ros::CallbackQueue calls;
  ros::NodeHandle services;
  services.setCallbackQueue(&calls);
  wend_ros::PlannerNode planner(node, own, services);
  const wend_ros::MasterWatch watch;
  constexpr int kThreads = 4;
  ros::AsyncSpinner call_spinner(kThreads, &calls);
  ros::AsyncSpinner spinner(2);
  call_spinner.start();
  spinner.start();
  ros::waitForShutdown();
  return 0;
}
