// Finds a function for its stub: the library is loaded, if it is not yet.

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {

// The number of a stub has two texts here: its library and its function.
extern const char wend_stub_names[];

[[gnu::visibility("hidden")]] void* wend_load_function(unsigned number) {
  const auto next = [](const char* text) { return text + std::strlen(text) + 1; };
  const char* library = wend_stub_names;
  for (unsigned i = 0; i < 2 * number; ++i) library = next(library);
  void* const loaded = dlopen(library, RTLD_NOW | RTLD_LOCAL);
  void* const function = loaded == nullptr ? nullptr : dlsym(loaded, next(library));
  if (function != nullptr) return function;
  std::fprintf(stderr, "wend: drawing needs %s, which cannot be loaded: %s\n", library, dlerror());
  std::_Exit(2);
}
}
