# The sources of wend_ros that need no ROS, beside those of ros/wend_ros; wend's own build compiles and tests them too.
set(wend_ros2_core_sources src/node_settings.cpp src/occupancy_costs.cpp)
