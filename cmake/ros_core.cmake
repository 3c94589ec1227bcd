# What the packages for ROS do that needs no ROS, for tests, fuzzers and tools that read the compile commands.
include("${PROJECT_SOURCE_DIR}/ros/core/core.cmake")
wend_add_ros_core(wend_ros_core wend_ros wend_nav2)
set_target_properties(wend_ros_core PROPERTIES EXCLUDE_FROM_ALL ON)
target_link_libraries(wend_ros_core PUBLIC wend_control wend_explore wend_io wend_session)

# The plugins of ROS 2 list their sources themselves.
include("${PROJECT_SOURCE_DIR}/ros2/wend_nav2/core_sources.cmake")
list(TRANSFORM wend_nav2_core_sources REPLACE "^.*/" "")
file(GLOB found RELATIVE "${PROJECT_SOURCE_DIR}/ros/core/wend_nav2" "${PROJECT_SOURCE_DIR}/ros/core/wend_nav2/*.cpp")
list(FILTER found EXCLUDE REGEX "_test\\.cpp$")
list(SORT found)
list(SORT wend_nav2_core_sources)
if(NOT found STREQUAL wend_nav2_core_sources)
  message(FATAL_ERROR "ros2/wend_nav2/core_sources.cmake does not list the sources of ros/core/wend_nav2")
endif()
