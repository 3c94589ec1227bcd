# Two small projects are built and run against wend: one finds the installed package, one has wend as
# a subdirectory. They are compiled as wend is: its libraries may need the sanitizers' run time.

set(prefix "${PROJECT_BINARY_DIR}/consumers/prefix")
set(static_prefix "${PROJECT_BINARY_DIR}/consumers/static_prefix")

# wend_add_consumer_test(<name> <folder> <option>...): configures, builds and runs tests/<folder>.
function(wend_add_consumer_test name folder)
  set(build_dir "${PROJECT_BINARY_DIR}/consumers/${name}")
  add_test(
    NAME consumer.${name}
    COMMAND
      "${CMAKE_CTEST_COMMAND}" --build-and-test "${PROJECT_SOURCE_DIR}/tests/${folder}"
      "${build_dir}" --build-generator "${CMAKE_GENERATOR}" --build-target consumer #
      --build-options "-DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}"
      "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}" "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
      "-DCMAKE_CXX_FLAGS_DEBUG=${CMAKE_CXX_FLAGS_DEBUG}"
      "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}" ${ARGN} #
      --test-command "${build_dir}/consumer" "${PROJECT_SOURCE_DIR}/tests/install_consumer/wall.txt")
  # 5 straight steps and 3 diagonal ones, around the wall's lower end.
  set_tests_properties(consumer.${name} PROPERTIES TIMEOUT 1200 PASS_REGULAR_EXPRESSION
                                                   "cost 9\\.24264, 9 cells")
endfunction()

if(WEND_INSTALL)
  add_test(NAME consumer.install COMMAND "${CMAKE_COMMAND}" --install "${PROJECT_BINARY_DIR}" --prefix
                                         "${prefix}")
  wend_add_consumer_test(find_package install_consumer "-DCMAKE_PREFIX_PATH=${prefix}")
  set_tests_properties(consumer.install PROPERTIES FIXTURES_SETUP installed)
  set_tests_properties(consumer.find_package PROPERTIES FIXTURES_REQUIRED installed)
  include(cmake/examples.cmake)
endif()

wend_add_consumer_test(add_subdirectory subdirectory_consumer "-DWEND_DIR=${PROJECT_SOURCE_DIR}"
                       -DWEND_UNITY=ON -DWEND_PRECOMPILE=ON -DWEND_INSTALL=ON
                       "-DCMAKE_INSTALL_PREFIX=${static_prefix}")
# It compiles the library a second time, and so does what needs it: for `./run test --all` and CI.
set_tests_properties(consumer.add_subdirectory PROPERTIES LABELS long)

# What is installed here is libwend.so. The static libraries are those of the project above.
if(WEND_INSTALL AND BUILD_SHARED_LIBS)
  add_test(NAME consumer.install_static
           COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}/consumers/add_subdirectory" --target install)
  wend_add_consumer_test(find_static_package install_consumer "-DCMAKE_PREFIX_PATH=${static_prefix}")
  set_tests_properties(consumer.add_subdirectory PROPERTIES FIXTURES_SETUP static_build)
  set_tests_properties(consumer.install_static PROPERTIES TIMEOUT 1200 FIXTURES_REQUIRED static_build
                                                          FIXTURES_SETUP static_installed)
  set_tests_properties(consumer.find_static_package PROPERTIES FIXTURES_REQUIRED static_installed)
  set_tests_properties(consumer.install_static consumer.find_static_package PROPERTIES LABELS long)
endif()
