# Tests are a few GoogleTest programs, and each runs in shards: ctest starts a process per shard, not
# per case. Cases that take long, by name All/... or ...LongRun..., have ctest tests of their own with
# the label "long"; ./run test leaves them out.

find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)

# RapidCheck with its macros for GoogleTest and gmock.
add_library(wend_rapidcheck INTERFACE)
target_link_libraries(wend_rapidcheck INTERFACE rapidcheck rapidcheck_gtest rapidcheck_gmock
                                                GTest::gtest fmt::fmt)

# The paths that tests know: only this is compiled with them, and each clone has its own.
add_library(wend_build_paths STATIC "${PROJECT_SOURCE_DIR}/tests/testing/build_paths.cpp")
target_include_directories(wend_build_paths PUBLIC "${PROJECT_SOURCE_DIR}")
target_compile_definitions(wend_build_paths PRIVATE WEND_DATA="${WEND_DATA}"
                                                    WEND_SOURCE_DIR="${PROJECT_SOURCE_DIR}")

set(wend_long_cases "All/*:*LongRun*")

# wend_add_shards(<target> <name> <shards> <filter> <timeout> [<label>]): <name>.<shard> for each shard.
function(wend_add_shards target name shards filter timeout)
  math(EXPR last "${shards} - 1")
  foreach(shard RANGE ${last})
    add_test(NAME ${name}.${shard} COMMAND ${target} "--gtest_filter=${filter}")
    set_tests_properties(
      ${name}.${shard}
      PROPERTIES TIMEOUT ${timeout}
                 ENVIRONMENT "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${shard}"
                 LABELS "${ARGN}")
  endforeach()
endfunction()

# wend_add_test_program(<target> <name> SHARDS <n> SOURCES <file>... LIBRARIES <target>...): ctest names
# are <name>.<shard> and <name>.long.<shard>.
function(wend_add_test_program target name)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "SHARDS" "SOURCES;LIBRARIES")
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE ${arg_LIBRARIES} wend_build_paths wend_rapidcheck GTest::gmock_main)
  wend_compile_text(${target})
  wend_precompile(${target} test)
  wend_unite(${target} WEND_UNITY_TESTS)
  wend_add_shards(${target} ${name} ${arg_SHARDS} "-${wend_long_cases}" 900)
  wend_add_shards(${target} ${name}.long ${arg_SHARDS} "${wend_long_cases}" 3600 long)
endfunction()
