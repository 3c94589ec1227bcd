// planner_server: wend's planners as a node; see planner_node.hpp and docs/ros.md.

#include <malloc.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <string>

#include "wend_ros/master_watch.hpp"
#include "wend_ros/planner_node.hpp"
#include "wend_ros/plugins.hpp"

namespace {

/// Lets all threads share freed memory: maps and planners are made and freed by turns, and with a heap for
/// each thread that adds up.
void share_memory() {
#ifdef M_ARENA_MAX
  mallopt(M_ARENA_MAX, 1);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  share_memory();
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
