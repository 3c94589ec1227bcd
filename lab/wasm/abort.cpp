// What the C++ library calls when it ends the program. Its own functions format a message for a terminal, which takes
// 20 KB; a program may replace them.

#include <__verbose_abort>

void std::__libcpp_verbose_abort(const char* /*format*/, ...) noexcept { __builtin_trap(); }

/// The same for pure virtual functions that are called, and the like.
extern "C" [[noreturn]] void __abort_message(const char* /*format*/, ...) { __builtin_trap(); }
