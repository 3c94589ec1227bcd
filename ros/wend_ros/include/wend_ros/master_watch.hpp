#pragma once

// MasterWatch: ends a node that the master no longer knows. A restarted master knows no nodes, and
// nodes do not register again: they would run without connections. Launch files respawn the node.

#include <ros/ros.h>

namespace wend_ros {

class MasterWatch {
 public:
  MasterWatch();

 private:
  void look(const ros::WallTimerEvent& event);

  ros::NodeHandle node_;
  ros::WallTimer timer_;
};

}  // namespace wend_ros
