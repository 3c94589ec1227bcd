# Debian's generated message headers rebind allocators in a way that C++20 has removed. This writes
# corrected copies of those headers, type by type the same, into a folder to be searched first. A copy
# that is there is left alone, or all would be compiled again after every configuration.
#
#   wend_ros_cxx20_headers(<folder> <message package>...)
function(wend_ros_cxx20_headers folder)
  find_path(WEND_ROS_SYSTEM_HEADERS ros/serialization.h REQUIRED)
  mark_as_advanced(WEND_ROS_SYSTEM_HEADERS)
  foreach(package IN ITEMS ros ${ARGN})
    file(GLOB headers RELATIVE "${WEND_ROS_SYSTEM_HEADERS}"
         "${WEND_ROS_SYSTEM_HEADERS}/${package}/*.h")
    foreach(header IN LISTS headers)
      file(READ "${WEND_ROS_SYSTEM_HEADERS}/${header}" text)
      string(FIND "${text}" "ContainerAllocator::template rebind<" found)
      if(found EQUAL -1)
        continue()
      endif()
      string(REPLACE "ContainerAllocator::template rebind<"
                     "std::allocator_traits<ContainerAllocator>::template rebind_alloc<" text
                     "${text}")
      string(REPLACE ">::other" ">" text "${text}")
      # A header that includes a neighbour by quotes would find the one beside the original.
      string(REGEX REPLACE "#include \"([^\"/]*)\"" "#include <${package}/\\1>" text "${text}")
      set(written "")
      if(EXISTS "${folder}/${header}")
        file(READ "${folder}/${header}" written)
      endif()
      if(NOT text STREQUAL written)
        file(WRITE "${folder}/${header}" "${text}")
      endif()
    endforeach()
  endforeach()
endfunction()
