# What the ROS nodes make of map messages, which needs no ROS: it is fuzzed with the loaders.
set(folder "${PROJECT_SOURCE_DIR}/ros/wend_ros")
add_library(wend_map_messages STATIC EXCLUDE_FROM_ALL "${folder}/src/occupancy.cpp"
                                                      "${folder}/src/occupancy_map.cpp")
target_include_directories(wend_map_messages PUBLIC "${folder}/include")
target_link_libraries(wend_map_messages PUBLIC wend_io)
