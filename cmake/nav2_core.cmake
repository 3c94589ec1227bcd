# What the packages of ROS 2 do that needs no ROS. ros2/wend_nav2 and ros2/wend_ros build the same sources, with colcon.
set(folder "${PROJECT_SOURCE_DIR}/ros2/wend_nav2")
include("${folder}/core_sources.cmake")
list(TRANSFORM wend_nav2_core_sources PREPEND "${folder}/")
add_library(wend_nav2_core STATIC EXCLUDE_FROM_ALL ${wend_nav2_core_sources})
target_include_directories(wend_nav2_core PUBLIC "${folder}/include")
target_link_libraries(wend_nav2_core PUBLIC wend_control wend_io wend_session)

set(folder "${PROJECT_SOURCE_DIR}/ros2/wend_ros")
include("${folder}/core_sources.cmake")
list(TRANSFORM wend_ros2_core_sources PREPEND "${folder}/")
add_library(wend_ros2_core STATIC EXCLUDE_FROM_ALL ${wend_ros2_core_sources})
target_include_directories(wend_ros2_core PUBLIC "${folder}/include")
target_link_libraries(wend_ros2_core PUBLIC wend_nav2_core wend_messages)
