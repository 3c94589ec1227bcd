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

# wend_add_pkg_config_test(<name> <prefix> <fixture>): the example in C, built by a C compiler and pkg-config alone.
function(wend_add_pkg_config_test name prefix fixture)
  set(program "${PROJECT_BINARY_DIR}/consumers/${name}")
  set(build "cc -std=c99 -Wall -Wextra -pedantic -Werror '${PROJECT_SOURCE_DIR}/examples/plan_in_c.c' -o '${program}'")
  add_test(NAME consumer.${name}_build
           COMMAND sh -c "${build} $(pkg-config --cflags --libs wend) -Wl,-rpath,$(pkg-config --variable=libdir wend)")
  add_test(NAME consumer.${name}
           COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=${program}"
                   "-DEXPECTED=${PROJECT_SOURCE_DIR}/examples/expected/plan_in_c.txt" -P
                   "${PROJECT_SOURCE_DIR}/cmake/same_output.cmake")
  set_tests_properties(
    consumer.${name}_build
    PROPERTIES FIXTURES_REQUIRED ${fixture} FIXTURES_SETUP ${name} ENVIRONMENT
                                                             "PKG_CONFIG_PATH=${prefix}/${CMAKE_INSTALL_LIBDIR}/pkgconfig")
  set_tests_properties(consumer.${name} PROPERTIES FIXTURES_REQUIRED ${name})
endfunction()
include(GNUInstallDirs)
wend_add_pkg_config_test(pkg_config "${prefix}" installed)
if(BUILD_SHARED_LIBS)
  wend_add_pkg_config_test(static_pkg_config "${static_prefix}" static_installed)
  # What they need compiles the library a second time.
  set_tests_properties(consumer.static_pkg_config consumer.static_pkg_config_build PROPERTIES LABELS long)
endif()

if(NOT TARGET wend_cli)
  return()
endif()
# The map that some of them load.
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/consumers")
add_test(NAME consumer.example_map COMMAND wend_cli generate office --size 160x100 --seed 7 -o
                                           "${PROJECT_BINARY_DIR}/consumers/office.yaml")
set_tests_properties(consumer.example_map PROPERTIES FIXTURES_SETUP examples)
file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/examples/*.cpp"
     "${PROJECT_SOURCE_DIR}/examples/*.c")
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
