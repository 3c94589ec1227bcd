# What the library needs from outside. The installed wendConfig.cmake looks for the same things.

set(wend_packages Threads tl-expected fmt yaml-cpp PNG GIF nlohmann_json)
set(wend_pkgconfig_modules cairo chafa)

# Targets are global, for whoever links wend::wend from outside this folder.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL TRUE)

foreach(package IN LISTS wend_packages)
  find_package(${package} REQUIRED)
endforeach()

find_package(PkgConfig REQUIRED)
foreach(module IN LISTS wend_pkgconfig_modules)
  pkg_check_modules(wend_${module} REQUIRED IMPORTED_TARGET GLOBAL ${module})
endforeach()
