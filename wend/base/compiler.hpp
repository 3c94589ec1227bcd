#pragma once

// What differs between compilers.

/// Marks what a shared object exports, whatever it is compiled with.
#define WEND_EXPORT __attribute__((visibility("default")))

/// Marks the classes and functions that a shared library exports. Every symbol without it is hidden.
/// WEND_SHARED is defined for wend as a shared library and for those who link it.
#if defined(WEND_SHARED)
#define WEND_API WEND_EXPORT
#else
#define WEND_API
#endif
