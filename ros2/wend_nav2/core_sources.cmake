# What the plugins do that needs no ROS, from this folder. Its headers are below include/, a link to ros/core.
set(wend_nav2_core_sources
    ../../ros/core/wend_nav2/control_settings.cpp
    ../../ros/core/wend_nav2/costmap_copy.cpp
    ../../ros/core/wend_nav2/failure.cpp
    ../../ros/core/wend_nav2/orientation.cpp
    ../../ros/core/wend_nav2/path_follower.cpp
    ../../ros/core/wend_nav2/path_pieces.cpp
    ../../ros/core/wend_nav2/path_planner.cpp
    ../../ros/core/wend_nav2/path_poses.cpp
    ../../ros/core/wend_nav2/path_smoother.cpp
    ../../ros/core/wend_nav2/planner_settings.cpp
    ../../ros/core/wend_nav2/pose_faults.cpp
    ../../ros/core/wend_nav2/request_settings.cpp
    ../../ros/core/wend_nav2/robot_shape.cpp
    ../../ros/core/wend_nav2/safe_velocity.cpp
    ../../ros/core/wend_nav2/way_ahead.cpp)
