# What the packages for ROS do that needs no ROS, for tests, fuzzers and tools that read the compile commands.
include("${PROJECT_SOURCE_DIR}/ros/core/core.cmake")
wend_add_ros_core(wend_ros_core wend_ros wend_nav2)
set_target_properties(wend_ros_core PROPERTIES EXCLUDE_FROM_ALL ON)
target_link_libraries(wend_ros_core PUBLIC wend_control wend_explore wend_io wend_session)
