# What the nodes and plugins of ROS 1 and ROS 2 do that needs no ROS: wend_ros/ is of the nodes, wend_nav2/ of the
# plugins for Nav2. The packages, which catkin and colcon build, and wend's own build, which tests it, include this file.
#
#   include(../core/core.cmake)
#   wend_add_ros_core(wend_ros_core wend_ros)
#   target_link_libraries(wend_ros_core PUBLIC wend::wend)

# wend_add_ros_core(<target> <folder>...): a static library of these folders.
function(wend_add_ros_core target)
  # A workspace may hold a link to a package.
  file(REAL_PATH "${CMAKE_CURRENT_FUNCTION_LIST_DIR}" core)
  add_library(${target} STATIC)
  foreach(folder IN LISTS ARGN)
    file(GLOB sources CONFIGURE_DEPENDS "${core}/${folder}/*.cpp")
    list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
    target_sources(${target} PRIVATE ${sources})
  endforeach()
  target_include_directories(${target} PUBLIC "${core}")
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()
