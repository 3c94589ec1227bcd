# `cmake --install`: public headers, libraries, the program, and what find_package(wend) and pkg-config read.
# The components are those of the Debian packages: runtime, development and program.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/wend")

install(
  TARGETS ${wend_targets}
  EXPORT wendTargets
  LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development
  INCLUDES
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
foreach(header IN LISTS wend_public_headers)
  cmake_path(GET header PARENT_PATH folder)
  install(
    FILES "${PROJECT_SOURCE_DIR}/${header}"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${folder}"
    COMPONENT development)
endforeach()
if(TARGET wend_cli)
  install(TARGETS wend_cli wend_bench_cli COMPONENT program)
  if(WEND_DEBIAN AND BUILD_SHARED_LIBS)
    # The loader finds the library of the package without a path.
    foreach(program wend wend-bench)
      install(
        CODE "file(RPATH_REMOVE FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}/${program}\")"
        COMPONENT program)
    endforeach()
  endif()
endif()

install(
  EXPORT wendTargets
  NAMESPACE wend::
  DESTINATION "${package_dir}"
  COMPONENT development)

string(JOIN " " wend_packages ${wend_packages})
string(JOIN " " wend_io_packages ${wend_io_packages})
string(JOIN " " wend_installed_modules ${wend_installed_modules})
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/wendConfig.cmake.in" wendConfig.cmake
                              INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(wendConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(
  FILES "${CMAKE_CURRENT_BINARY_DIR}/wendConfig.cmake"
        "${CMAKE_CURRENT_BINARY_DIR}/wendConfigVersion.cmake"
  DESTINATION "${package_dir}"
  COMPONENT development)

# Static libraries need what they are made of; a shared one brings it.
if(BUILD_SHARED_LIBS)
  set(pc_libraries "-lwend")
  set(pc_requires "")
  set(pc_flags "-DWEND_SHARED")
else()
  set(pc_libraries "")
  foreach(target IN LISTS wend_targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
      set(pc_libraries "-l${target} ${pc_libraries}")
    endif()
  endforeach()
  # A C compiler does not add those of C++.
  string(APPEND pc_libraries "-pthread -lstdc++ -lm")
  set(pc_requires "fmt yaml-cpp libpng libjpeg")
  set(pc_flags "")
endif()
file(RELATIVE_PATH pc_to_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file("${PROJECT_SOURCE_DIR}/cmake/wend.pc.in" wend.pc @ONLY)
install(
  FILES "${CMAKE_CURRENT_BINARY_DIR}/wend.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
  COMPONENT development)
