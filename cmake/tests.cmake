# Every GoogleTest case is a ctest test. Those that take long, by name All/... or ...LongRun..., have the
# label "long"; ./run test leaves them out.

find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)
include(GoogleTest)

# RapidCheck with its macros for GoogleTest and gmock.
add_library(wend_rapidcheck INTERFACE)
target_link_libraries(wend_rapidcheck INTERFACE rapidcheck rapidcheck_gtest rapidcheck_gmock
                                                GTest::gtest fmt::fmt)

# wend_add_test(<target> <prefix> SOURCES <file>... LIBRARIES <target>...): ctest names are
# <prefix>.<suite>.<case>.
function(wend_add_test target prefix)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "SOURCES;LIBRARIES")
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE ${arg_LIBRARIES} wend_rapidcheck GTest::gmock_main)
  wend_precompile(${target} test)
  target_compile_definitions(${target} PRIVATE WEND_DATA="${WEND_DATA}"
                                               WEND_SOURCE_DIR="${PROJECT_SOURCE_DIR}")

  set(common TEST_PREFIX ${prefix}. DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120)
  set(long "All/*:*LongRun*")
  gtest_discover_tests(${target} ${common} TEST_FILTER "-${long}" PROPERTIES TIMEOUT 300)
  gtest_discover_tests(${target} ${common} TEST_FILTER "${long}" PROPERTIES TIMEOUT 3600 LABELS long)
endfunction()

# wend_add_module_tests(<module>...): wend/<module>/*_test.cpp become the program
# wend_<module>_test, which links that module.
function(wend_add_module_tests)
  foreach(module IN LISTS ARGN)
    file(GLOB sources CONFIGURE_DEPENDS ${module}/*_test.cpp)
    if(sources)
      wend_add_test(wend_${module}_test ${module} SOURCES ${sources} LIBRARIES wend::${module})
    endif()
  endforeach()
endfunction()
