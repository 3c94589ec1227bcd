#pragma once

// The version of wend: MAJOR.MINOR.PATCH. While MAJOR is 0, a new MINOR may change the interface.
// CMake checks that it is the version of the project.

/// The first number of the version.
#define WEND_VERSION_MAJOR 0
/// The second number of the version.
#define WEND_VERSION_MINOR 2
/// The third number of the version.
#define WEND_VERSION_PATCH 0
/// The version as text: "MAJOR.MINOR.PATCH".
#define WEND_VERSION "0.2.0"
