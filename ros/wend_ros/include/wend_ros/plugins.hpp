#pragma once

// Planners from outside, from the shared objects that ~plugins names: a list, or a text with commas.
//
//   rosrun wend_ros planner_server _plugins:=/path/libswirl.so _planner:=swirl

#include <ros/ros.h>

#include <string>
#include <vector>

#include "wend/base/expected.hpp"

namespace wend_ros {

/// The files that a value of ~plugins names, or what is wrong with it.
wend::Expected<std::vector<std::string>, std::string> plugin_files(XmlRpc::XmlRpcValue value);

/// Loads the planners of ~plugins into the registry; before anything reads it. What is wrong, with the name of
/// the file; empty if nothing is.
std::string load_plugins(const ros::NodeHandle& own);

}  // namespace wend_ros
