// planner_server: wend's planners as a node; see planner_node.hpp and docs/ros.md.

#include <ros/ros.h>

#include "wend_ros/planner_node.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "planner_server");
  ros::NodeHandle node;
  ros::NodeHandle own("~");
  wend_ros::PlannerNode planner(node, own);
  // A service call that plans holds one of them; topics go on in the others.
  constexpr int kThreads = 4;
  ros::AsyncSpinner spinner(kThreads);
  spinner.start();
  ros::waitForShutdown();
  return 0;
}
