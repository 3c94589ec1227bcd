// A plugin that was compiled for another version of wend. Nothing of it may run.

#include <cstdlib>

#define WEND_MARKED __attribute__((visibility("default"), used))

extern "C" {
extern WEND_MARKED const char wend_plugin_version[];
const char wend_plugin_version[] = "wend-plugin-version=0.1.7";
}

namespace {

struct EndsTheProgram {
  EndsTheProgram() { std::abort(); }
};
const EndsTheProgram ends_the_program;

}  // namespace
