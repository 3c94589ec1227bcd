# The examples are built against the installed package, and print what examples/expected has. README.md shows
# plan_path.

set(build_dir "${PROJECT_BINARY_DIR}/consumers/examples")
add_test(
  NAME consumer.examples
  COMMAND
    "${CMAKE_CTEST_COMMAND}" --build-and-test "${PROJECT_SOURCE_DIR}/examples" "${build_dir}"
    --build-generator "${CMAKE_GENERATOR}" --build-options "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}" "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}" "-DCMAKE_CXX_FLAGS_DEBUG=${CMAKE_CXX_FLAGS_DEBUG}"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}")
set_tests_properties(consumer.examples PROPERTIES TIMEOUT 1200 FIXTURES_REQUIRED installed
                                                  FIXTURES_SETUP examples)

if(NOT TARGET wend_cli)
  return()
endif()
# The map that some of them load.
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/consumers")
add_test(NAME consumer.example_map COMMAND wend_cli generate office --size 160x100 --seed 7 -o
                                           "${PROJECT_BINARY_DIR}/consumers/office.yaml")
set_tests_properties(consumer.example_map PROPERTIES FIXTURES_SETUP examples)
file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/examples/*.cpp")
list(FILTER sources EXCLUDE REGEX "/swirl\\.cpp$")
foreach(source IN LISTS sources)
  cmake_path(GET source STEM name)
  add_test(
    NAME consumer.example.${name}
    COMMAND
      "${CMAKE_COMMAND}" "-DPROGRAM=${build_dir}/example_${name}"
      "-DEXPECTED=${PROJECT_SOURCE_DIR}/examples/expected/${name}.txt" -P
      "${PROJECT_SOURCE_DIR}/cmake/same_output.cmake"
    WORKING_DIRECTORY "${PROJECT_BINARY_DIR}/consumers")
  set_tests_properties(consumer.example.${name} PROPERTIES FIXTURES_REQUIRED examples)
endforeach()

# The plugin, in the installed program.
if(BUILD_SHARED_LIBS)
  set(plan --plugin "${build_dir}/libswirl.so" plan office.yaml --start 1,1 --goal 0.85,0.85 --planner swirl
           --format csv)
  add_test(
    NAME consumer.example.swirl
    COMMAND
      "${CMAKE_COMMAND}" "-DPROGRAM=${prefix}/bin/wend" "-DARGUMENTS=${plan}"
      "-DEXPECTED=${PROJECT_SOURCE_DIR}/examples/expected/swirl.txt" -P
      "${PROJECT_SOURCE_DIR}/cmake/same_output.cmake"
    WORKING_DIRECTORY "${PROJECT_BINARY_DIR}/consumers")
  set_tests_properties(consumer.example.swirl PROPERTIES FIXTURES_REQUIRED examples)
endif()
