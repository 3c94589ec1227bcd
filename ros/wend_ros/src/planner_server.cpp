// planner_server: wend's planners as a node; see planner_node.hpp and docs/ros.md.

#include <malloc.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <string>

#include "wend_ros/master_watch.hpp"
#include "wend_ros/planner_node.hpp"
#include "wend_ros/plugins.hpp"

namespace {

/// Gives the memory of maps and planners back to the system as soon as they are deleted. Else what is left
/// between them adds up: on a map of 1000 x 1000 cells that changes, three times what is in use.
void return_memory() {
#ifdef M_MMAP_THRESHOLD
  constexpr int kLarge = 1'000'000;  // bytes
  mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  return_memory();
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
