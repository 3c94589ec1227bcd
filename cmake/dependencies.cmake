# What the library needs from outside. The installed wendConfig.cmake looks for the same things, but for those
# of reports, which are not installed.

set(wend_packages Threads tl-expected)
set(wend_io_packages fmt yaml-cpp PNG JPEG nlohmann_json)
set(wend_report_packages GIF)
set(wend_report_pkgconfig_modules cairo chafa)

# Targets are global, for whoever links wend::wend from outside this folder.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL TRUE)

foreach(package IN LISTS wend_packages wend_io_packages)
  find_package(${package} REQUIRED)
endforeach()

# Headers only: wend/io/image/bmp.cpp compiles what it needs of them.
find_path(wend_stb_folder stb/stb_image.h REQUIRED)

if(WEND_BUILD_REPORTS)
  foreach(package IN LISTS wend_report_packages)
    find_package(${package} REQUIRED)
  endforeach()
  find_package(PkgConfig REQUIRED)
  foreach(module IN LISTS wend_report_pkgconfig_modules)
    pkg_check_modules(wend_${module} REQUIRED IMPORTED_TARGET GLOBAL ${module})
  endforeach()
endif()
