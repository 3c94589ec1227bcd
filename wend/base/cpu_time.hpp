#pragma once

// cpu_seconds(): what the calling thread has computed so far, for budgets that do not depend on what else the machine
// does. On systems that do not count it, as in a browser, the time that has passed.

#include "wend/base/compiler.hpp"

namespace wend {

/// CPU seconds of the calling thread since some fixed moment, or seconds of the steady clock where the system has none.
WEND_API double cpu_seconds();

}  // namespace wend
