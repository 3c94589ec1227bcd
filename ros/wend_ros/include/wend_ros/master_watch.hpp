#pragma once

// MasterWatch: ends a node that the master has forgotten. A master that was restarted knows nobody;
// nodes do not tell it again who they are, so that they would run on unheard. Launch files start the
// node anew.

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
