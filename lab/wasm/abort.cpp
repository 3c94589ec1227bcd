// What the C++ library calls when it ends the program. Its own function formats a message for a terminal, which takes
// 20 KB; a program may replace it.

#include <__verbose_abort>

void std::__libcpp_verbose_abort(const char* /*format*/, ...) noexcept { __builtin_trap(); }
