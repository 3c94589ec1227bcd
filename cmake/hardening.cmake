# Checks that the compiler and the loader make at little cost, for all that is given to others: the release build, the
# Debian packages and the Python wheel. Debian's dpkg-buildflags asks for the same. Sanitizers have checks of their own.

option(WEND_HARDENING "Stack protector, checked copies, read-only relocations in optimised builds"
       ${PROJECT_IS_TOP_LEVEL})
if(NOT WEND_HARDENING
   OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux"
   OR NOT CMAKE_BUILD_TYPE MATCHES "^(Release|RelWithDebInfo|MinSizeRel)$")
  return()
endif()
add_compile_options(-fstack-protector-strong -fstack-clash-protection -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  add_compile_options(-fcf-protection)
endif()
add_link_options(LINKER:-z,relro LINKER:-z,now LINKER:-z,noexecstack)
