# Makes the library targets from wend/modules.txt: wend_<module> with the alias wend::<module>, and
# wend::wend, which is all of them.

include("${CMAKE_CURRENT_LIST_DIR}/loaded_late/loaded_late.cmake")

# Sets wend_modules to the modules' names and wend_arrows_<module> to what <module> may include.
macro(wend_read_modules)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS modules.txt)
  file(STRINGS modules.txt lines REGEX "^[a-z]")
  set(wend_modules "")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "^([a-z_]+)( core)?:([a-z_ ]*)$")
      message(FATAL_ERROR "wend/modules.txt: cannot read the line '${line}'")
    endif()
    set(module "${CMAKE_MATCH_1}")
    separate_arguments(wend_arrows_${module} UNIX_COMMAND "${CMAKE_MATCH_3}")
    list(APPEND wend_modules ${module})
  endforeach()
endmacro()

# Sets wend_public_headers to the paths in wend/public_headers.txt.
macro(wend_read_public_headers)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS public_headers.txt)
  file(STRINGS public_headers.txt wend_public_headers REGEX "^wend/")
endmacro()

# CMake and wend/version.hpp must agree on the version.
function(wend_check_version)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS version.hpp)
  file(READ version.hpp text)
  foreach(part MAJOR MINOR PATCH)
    if(NOT text MATCHES "#define WEND_VERSION_${part} ${PROJECT_VERSION_${part}}\n")
      message(FATAL_ERROR "WEND_VERSION_${part} in wend/version.hpp is not that of ${PROJECT_VERSION}")
    endif()
  endforeach()
  if(NOT text MATCHES "#define WEND_VERSION \"${PROJECT_VERSION}\"\n")
    message(FATAL_ERROR "WEND_VERSION in wend/version.hpp is not ${PROJECT_VERSION}")
  endif()
endfunction()

# wend_add_module(<module> <arrow>...): a static library of the sources in wend/<module> and its folders, or an
# interface target where there is nothing to compile.
function(wend_add_module module)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${module}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  list(TRANSFORM ARGN PREPEND wend_ OUTPUT_VARIABLE arrows)

  if(sources)
    add_library(wend_${module} STATIC ${sources})
    if(${module} IN_LIST wend_text_modules)
      wend_precompile(wend_${module} text)
    else()
      wend_precompile(wend_${module} standard)
    endif()
    # The more of an index is compiled together, the less of it is inlined where it looks paths up. A change of one
    # planner compiles those beside it again: the fewer the better.
    if(module STREQUAL "index" OR module STREQUAL "planner")
      wend_unite(wend_${module} WEND_UNITY 8)
    else()
      wend_unite(wend_${module} WEND_UNITY)
    endif()
    if(${module} IN_LIST wend_cold_modules)
      wend_compile_text(wend_${module})
    endif()
    # What is inlined into a loop that searches depends on what else is in its source: these are compiled alone.
    if(module STREQUAL "planner")
      set(loops ${sources})
      list(FILTER loops INCLUDE REGEX "/(best_first|ara_star|random_walk|jps|d_star_lite|[a-z_]*_engine)\\.cpp$")
      set_source_files_properties(${loops} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
    # It gives a type of its anonymous namespace to a class of its header, which a unity source may not.
    if(module STREQUAL "render")
      set_source_files_properties(render/animation/gif.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
    set(scope PUBLIC)
  else()
    add_library(wend_${module} INTERFACE)
    set(scope INTERFACE)
  endif()
  if(BUILD_SHARED_LIBS AND NOT ${module} IN_LIST wend_report_modules)
    add_library(wend::${module} ALIAS wend_shared)
  else()
    add_library(wend::${module} ALIAS wend_${module})
  endif()
  set_target_properties(wend_${module} PROPERTIES EXPORT_NAME ${module})
  target_compile_features(wend_${module} ${scope} cxx_std_20)
  target_include_directories(wend_${module} ${scope} "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>")
  target_link_libraries(wend_${module} ${scope} ${arrows})
endfunction()

# wend_module_needs(<module> <PUBLIC|PRIVATE> <library>...): libraries from outside. PUBLIC: the
# module's headers include theirs.
function(wend_module_needs module scope)
  get_target_property(type wend_${module} TYPE)
  if(type STREQUAL INTERFACE_LIBRARY)
    set(scope INTERFACE)
  endif()
  target_link_libraries(wend_${module} ${scope} ${ARGN})
endfunction()

# wend_link_program(<target> <library>...): links a program with the library, and with static libraries that
# use the modules. With libwend.so, it gets their objects and what they need from outside, but not the modules:
# there is one copy of those, for the program and its plugins.
function(wend_link_program target)
  if(NOT BUILD_SHARED_LIBS)
    target_link_libraries(${target} PRIVATE ${ARGN})
    return()
  endif()
  list(TRANSFORM wend_report_modules PREPEND wend_ OUTPUT_VARIABLE report_libraries)
  foreach(library IN LISTS ARGN report_libraries)
    get_target_property(needs ${library} LINK_LIBRARIES)
    list(FILTER needs EXCLUDE REGEX "^wend_|::wend_(cairo|chafa)$")
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${library}>)
    target_link_libraries(${target} PRIVATE ${needs})
  endforeach()
  target_link_libraries(${target} PRIVATE wend_shared)
  wend_load_drawing_late(${target})
  file(RELATIVE_PATH to_library "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
  # The build tree has the library where an installation has it, so that both can have the same path. CMake would
  # make room for another one with colons, and an empty path is the current folder, whose libraries anybody may
  # have written (scripts/check_library_paths).
  set(name "libwend.so.${PROJECT_VERSION_MAJOR}")
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
  file(CREATE_LINK "${PROJECT_BINARY_DIR}/wend/${name}" "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${name}"
       SYMBOLIC)
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${to_library}" BUILD_WITH_INSTALL_RPATH ON)
endfunction()

# wend_check_listed(<list.def> <macro> [<suffix>]): a registry is made from the list; what stands there as
# MACRO(name) has its own source file, name<suffix>.cpp, beside it or in a folder below.
function(wend_check_listed list macro)
  if(NOT EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${list}")
    return()
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  cmake_path(GET list PARENT_PATH folder)
  file(STRINGS ${list} lines REGEX "^${macro}\\(")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^${macro}\\( *([a-z0-9_]+).*" "\\1" name "${line}")
    file(GLOB_RECURSE its_source "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${name}${ARGV2}.cpp")
    if(NOT its_source)
      message(FATAL_ERROR "wend/${list} lists '${name}', but there is no file "
                          "${name}${ARGV2}.cpp in wend/${folder} or below")
    endif()
  endforeach()
endfunction()
