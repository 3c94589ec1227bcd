# `cmake --install`: headers, libraries, the program, and what find_package(wend) reads.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/wend")

install(
  TARGETS ${wend_targets}
  EXPORT wendTargets
  INCLUDES
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(
  DIRECTORY "${PROJECT_SOURCE_DIR}/wend"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  FILES_MATCHING
  PATTERN "*.hpp"
  PATTERN "*.def"
  PATTERN "*_test*.hpp" EXCLUDE)
if(TARGET wend_cli)
  install(TARGETS wend_cli)
endif()

install(
  EXPORT wendTargets
  NAMESPACE wend::
  DESTINATION "${package_dir}")

string(JOIN " " wend_packages ${wend_packages})
string(JOIN " " wend_pkgconfig_modules ${wend_pkgconfig_modules})
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/wendConfig.cmake.in" wendConfig.cmake
                              INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(wendConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/wendConfig.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/wendConfigVersion.cmake" DESTINATION "${package_dir}")
