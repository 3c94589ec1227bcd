# The sources of wend_nav2 that need no ROS; wend's own build compiles and tests them too.
set(wend_nav2_core_sources
    src/control_settings.cpp
    src/costmap_copy.cpp
    src/failure.cpp
    src/orientation.cpp
    src/path_follower.cpp
    src/path_pieces.cpp
    src/path_planner.cpp
    src/path_poses.cpp
    src/path_smoother.cpp
    src/planner_settings.cpp
    src/pose_faults.cpp
    src/robot_shape.cpp
    src/safe_velocity.cpp
    src/way_ahead.cpp)
