// SPDX-License-Identifier: Apache-2.0
#pragma once

// The types of Nav2 that differ between its releases: Jazzy and Kilted, or rolling and Lyrical, which have a package
// nav2_ros_common, and pass points on the way to planners.

#include <memory>

#include <nav2_costmap_2d/costmap_2d_ros.hpp>

#if __has_include(<nav2_ros_common/lifecycle_node.hpp>)
#define WEND_NAV2_VIAPOINTS 1
#include <nav2_ros_common/lifecycle_node.hpp>
#include <nav2_ros_common/tf2_factories.hpp>
#else
#define WEND_NAV2_VIAPOINTS 0
#include <tf2_ros/buffer.h>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#endif

#if __has_include(<nav2_costmap_2d/inflation_layer_interface.hpp>)
#include <nav2_costmap_2d/inflation_layer_interface.hpp>
#else
#include <nav2_costmap_2d/inflation_layer.hpp>
#endif

namespace wend_nav2 {

#if WEND_NAV2_VIAPOINTS
using Node = nav2::LifecycleNode;
using TransformBuffer = nav2::TransformBuffer::SharedPtr;
#else
using Node = rclcpp_lifecycle::LifecycleNode;
using TransformBuffer = std::shared_ptr<tf2_ros::Buffer>;
#endif

#if __has_include(<nav2_costmap_2d/inflation_layer_interface.hpp>)
using InflationLayer = nav2_costmap_2d::InflationLayerInterface;
#else
using InflationLayer = nav2_costmap_2d::InflationLayer;
#endif

}  // namespace wend_nav2
