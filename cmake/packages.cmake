# `cpack -G DEB`, in a build of the preset package: libwend0, libwend-dev and wend. scripts/package makes them
# and checks them. Every package, and every other installation, has the licences of wend and of the code of
# others that is compiled into it.

set(notices "${PROJECT_SOURCE_DIR}/cmake/debian_copyright")
if(NOT WEND_DEBIAN)
  install(
    FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${notices}"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/wend"
    COMPONENT development)
  return()
endif()
if(NOT BUILD_SHARED_LIBS)
  message(FATAL_ERROR "WEND_DEBIAN needs BUILD_SHARED_LIBS")
endif()

set(packages libwend${PROJECT_VERSION_MAJOR} libwend-dev wend)
set(components runtime development program)

set(CPACK_PACKAGE_NAME wend)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "The wend developers <wend@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
                                                GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libwend${PROJECT_VERSION_MAJOR})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
file(WRITE "${PROJECT_BINARY_DIR}/debian/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/debian/triggers")
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION
    "wend plans paths for robots on grid maps, smooths them and follows them. It
reads the maps of ROS and of MovingAI, and has classic and fast exact planners
behind one interface.
.
This package has the library that programs need to run.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libwend-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libwend${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION}-1), libexpected-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "wend plans paths for robots on grid maps, smooths them and follows them.
.
This package has the headers for C++ and C, and what CMake and pkg-config read.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME wend)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
# The program uses the library of this build: dpkg-shlibdeps finds it there, but knows no package of it.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/wend")
# It loads cairo and chafa when it draws, which dpkg-shlibdeps does not see.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS
    "libwend${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION}-1), libcairo2, libchafa0, libglib2.0-0")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "wend plans paths for robots on grid maps, smooths them and follows them.
.
This package has the program: it plans, explains and draws in the terminal and
to files, and compares and measures planners.")

# Policy asks every package for its licence and its changelog, and for compressed pages.
find_program(WEND_GZIP gzip REQUIRED)
mark_as_advanced(WEND_GZIP)
set(doc "${PROJECT_BINARY_DIR}/debian")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${notices}" "${doc}/copyright" COPYONLY)
file(WRITE "${doc}/changelog.Debian"
     "wend (${PROJECT_VERSION}-1) unstable; urgency=medium\n\n"
     "  * Package version ${PROJECT_VERSION}; changelog.gz has its changes.\n\n"
     " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
configure_file("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${doc}/changelog" COPYONLY)
execute_process(COMMAND "${WEND_GZIP}" -9nf "${doc}/changelog" "${doc}/changelog.Debian"
                        COMMAND_ERROR_IS_FATAL ANY)
foreach(package component IN ZIP_LISTS packages components)
  install(
    FILES "${doc}/copyright" "${doc}/changelog.gz" "${doc}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
    COMPONENT ${component})
endforeach()

include(CPack)
