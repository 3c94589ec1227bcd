# Writes the man pages from the program's help each time that the program is linked. This needs Python.

find_package(Python3 COMPONENTS Interpreter QUIET)
if(NOT Python3_FOUND OR CMAKE_CROSSCOMPILING)
  message(STATUS "No man pages: they need Python and a program that runs on this machine")
  return()
endif()

include(GNUInstallDirs)
set(man_folder "${PROJECT_BINARY_DIR}/man/man1")
add_custom_command(
  TARGET wend_bench_cli
  POST_BUILD
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${man_folder}"
  COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/scripts/reference.py" man
          "$<TARGET_FILE:wend_bench_cli>" "${man_folder}"
  VERBATIM)
if(WEND_DEBIAN)
  add_custom_command(TARGET wend_bench_cli POST_BUILD COMMAND gzip -9nrf "${man_folder}" VERBATIM)
endif()
install(DIRECTORY "${man_folder}" DESTINATION "${CMAKE_INSTALL_MANDIR}" COMPONENT program)
