#pragma once

// The process of a node, for tests that kill it.

#include <ros/network.h>
#include <ros/ros.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <string>

namespace wend_ros {

/// 0 if the master does not know it, or it does not answer.
inline int pid_of(const std::string& name) {
  XmlRpc::XmlRpcValue arguments;
  XmlRpc::XmlRpcValue result;
  XmlRpc::XmlRpcValue payload;
  arguments[0] = ros::this_node::getName();
  arguments[1] = name;
  if (!ros::master::execute("lookupNode", arguments, result, payload, false)) return 0;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(static_cast<std::string>(payload), host, port)) return 0;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue caller;
  caller[0] = ros::this_node::getName();
  XmlRpc::XmlRpcValue answer;
  if (!client.execute("getPid", caller, answer)) return 0;
  return static_cast<int>(answer[2]);
}

}  // namespace wend_ros
