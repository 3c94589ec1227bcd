# The commit that is built, as one small source file, so that no other is compiled anew when it
# changes.
#
# Included, it makes the rule: `wend_add_commit(<target>)` gives a target the file, looked at in every
# build. Run as a script (cmake -DSOURCE=... -DTARGET=... -P commit.cmake) it writes the file.

if(CMAKE_SCRIPT_MODE_FILE)
  set(commit "")
  find_program(GIT git)
  if(GIT)
    # A checkout of something else around ours says nothing about ours.
    execute_process(COMMAND "${GIT}" rev-parse --show-toplevel WORKING_DIRECTORY "${SOURCE}"
                    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    cmake_path(COMPARE "${top}" EQUAL "${SOURCE}" is_ours)
    if(is_ours)
      execute_process(COMMAND "${GIT}" describe --always --dirty --abbrev=12 --exclude=*
                      WORKING_DIRECTORY "${SOURCE}" OUTPUT_VARIABLE commit
                      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    endif()
  endif()
  if(NOT commit)
    set(commit unknown)
  endif()
  # Leaves the file as it is if nothing changed.
  file(CONFIGURE OUTPUT "${TARGET}" @ONLY CONTENT [[
#include "wend/report/build_info.hpp"

namespace wend {

std::string_view wend_commit() { return "@commit@"; }

}  // namespace wend
]])
  return()
endif()

set(wend_commit_script "${CMAKE_CURRENT_LIST_FILE}")

function(wend_add_commit target)
  set(file "${CMAKE_CURRENT_BINARY_DIR}/commit.cpp")
  add_custom_target(
    ${target}_commit
    COMMAND "${CMAKE_COMMAND}" "-DSOURCE=${PROJECT_SOURCE_DIR}" "-DTARGET=${file}" -P
            "${wend_commit_script}"
    BYPRODUCTS "${file}"
    VERBATIM)
  target_sources(${target} PRIVATE "${file}")
  set_source_files_properties("${file}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  add_dependencies(${target} ${target}_commit)
endfunction()
