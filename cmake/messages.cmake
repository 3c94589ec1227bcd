# What the ROS nodes make of maps and paths in messages, which needs no ROS: it is fuzzed with the loaders.
set(folder "${PROJECT_SOURCE_DIR}/ros/wend_ros")
add_library(wend_messages STATIC EXCLUDE_FROM_ALL
                          "${folder}/src/given_path.cpp" "${folder}/src/occupancy.cpp"
                          "${folder}/src/occupancy_map.cpp" "${folder}/src/orientation.cpp"
                          "${folder}/src/tracking.cpp")
target_include_directories(wend_messages PUBLIC "${folder}/include")
target_link_libraries(wend_messages PUBLIC wend_control wend_io)
