#pragma once

// The version of wend: MAJOR.MINOR.PATCH. While MAJOR is 0, a new MINOR may change the interface.
// CMake checks that it is the version of the project.

#define WEND_VERSION_MAJOR 0
#define WEND_VERSION_MINOR 2
#define WEND_VERSION_PATCH 0
#define WEND_VERSION "0.2.0"
