# What makes a build quick: headers of dependencies are precompiled, and sources are compiled several
# at a time (a unity build). Templates of the JSON library, of gmock and of {fmt} are then instantiated
# once for many sources, which is most of what a build does.
#
# A source never relies on either: it includes what it uses, and CI compiles every source but the tests
# by itself, without precompiled headers, once (the preset sanitize). For a unity build, names in the anonymous
# namespaces of a folder differ from each other; tests and other sources are kept apart.

option(WEND_PRECOMPILE "Precompile the headers of dependencies" ${PROJECT_IS_TOP_LEVEL})
option(WEND_UNITY "Compile several sources at a time" ${PROJECT_IS_TOP_LEVEL})
option(WEND_PRECOMPILE_TESTS "The same of the tests" ${PROJECT_IS_TOP_LEVEL})
option(WEND_UNITY_TESTS "The same of the tests" ${PROJECT_IS_TOP_LEVEL})

set(WEND_UNITY_SIZE
    8
    CACHE STRING "How many sources of a folder are compiled together")

set(WEND_TEXT_OPTIONS
    ""
    CACHE STRING "Options, besides the others, of sources that make text, and of tests")

# GCC collects garbage as soon as it has 128 MB. With 512 MB it hardly ever does: a fifth less CPU time for the large
# sources, with a third more memory, at most 1.1 GB a compiler.
if(PROJECT_IS_TOP_LEVEL AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options("--param=ggc-min-heapsize=524288")
endif()

set(wend_precompiled_standard
    <algorithm>
    <array>
    <atomic>
    <bit>
    <cassert>
    <charconv>
    <cmath>
    <cstddef>
    <cstdint>
    <cstring>
    <functional>
    <limits>
    <map>
    <memory>
    <mutex>
    <numeric>
    <optional>
    <set>
    <span>
    <string>
    <string_view>
    <tl/expected.hpp>
    <utility>
    <variant>
    <vector>)
set(wend_precompiled_text ${wend_precompiled_standard} <filesystem> <fmt/format.h>
                          <nlohmann/json.hpp>)
set(wend_precompiled_test ${wend_precompiled_text} <gmock/gmock.h> <gtest/gtest.h>
                          <rapidcheck/gtest.h>)

# wend_precompile(<target> <standard|text|test>): the first target of a kind compiles the headers, the
# others use what it made. All targets of a kind are compiled with the same options.
function(wend_precompile target kind)
  if((kind STREQUAL "test" AND NOT WEND_PRECOMPILE_TESTS)
     OR (NOT kind STREQUAL "test" AND NOT WEND_PRECOMPILE))
    return()
  endif()
  get_property(owner GLOBAL PROPERTY wend_precompiled_${kind}_owner)
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE ${wend_precompiled_${kind}})
    set_property(GLOBAL PROPERTY wend_precompiled_${kind}_owner ${target})
  endif()
endfunction()

# wend_compile_text(<target>): most of what compiles slowly need not run fast: the program itself, reports,
# sessions, tests. Nothing that is timed.
function(wend_compile_text target)
  target_compile_options(${target} PRIVATE ${WEND_TEXT_OPTIONS})
endfunction()

# wend_unite(<target> <option> [<most>]): where the option is on, sources of one folder are compiled
# together, some at a time, at most so many.
function(wend_unite target option)
  if(NOT ${option})
    return()
  endif()
  set(size ${WEND_UNITY_SIZE})
  if(ARGC GREATER 2 AND ARGV2 LESS size)
    set(size ${ARGV2})
  endif()
  get_target_property(sources ${target} SOURCES)
  set(count 0)
  set(last_folder "")
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(ABSOLUTE_PATH folder)
    if(NOT folder STREQUAL last_folder)
      set(count 0)
      set(last_folder "${folder}")
    endif()
    math(EXPR group "${count} / ${size}")
    math(EXPR count "${count} + 1")
    cmake_path(GET folder FILENAME name)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${name}_${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A name of a function may be that of another source's constant; the preset sanitize warns of the rest.
  target_compile_options(${target} PRIVATE -Wno-shadow)
endfunction()
