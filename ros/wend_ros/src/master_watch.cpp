#include "wend_ros/master_watch.hpp"

namespace wend_ros {

MasterWatch::MasterWatch() {
  const ros::WallDuration period(2);
  timer_ = node_.createWallTimer(period, &MasterWatch::look, this);
}

void MasterWatch::look(const ros::WallTimerEvent&) {
  XmlRpc::XmlRpcValue arguments;
  XmlRpc::XmlRpcValue result;
  XmlRpc::XmlRpcValue payload;
  arguments[0] = ros::this_node::getName();
  arguments[1] = ros::this_node::getName();
  if (!ros::master::check()) {
    ROS_WARN_THROTTLE(10, "the master does not answer");
    return;
  }
  // It answers: then it knows this node, or is another one than before.
  if (ros::master::execute("lookupNode", arguments, result, payload, false)) return;
  ROS_ERROR("the master was restarted and does not know this node: it ends, to be started anew");
  ros::requestShutdown();
}

}  // namespace wend_ros
