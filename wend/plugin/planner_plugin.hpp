#pragma once

// A plugin: a shared object with planners that programs load at run time.
//
//   wend::PlannerInfo swirl_planner();
//   WEND_PLANNER_PLUGIN(swirl_planner)
//
// `wend --plugin libswirl.so plan MAP --planner swirl` uses it, and load_planners()
// (wend/plugin/load_planners.hpp) loads it in a program of yours. examples/swirl.cpp is a whole plugin.
//
// Program and plugin exchange C++ objects, so they must use the same libwend.so, of the version that both
// were compiled for. A program reads the version in the plugin's file and refuses another one, before any
// code of the plugin runs.

#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/planner/planners.hpp"
#include "wend/version.hpp"

/// What stands before the version in the file of a plugin.
#define WEND_PLUGIN_VERSION_MARK "wend-plugin-version="

/// Defines what a program looks for in a plugin. The arguments are functions without parameters that
/// return a PlannerInfo, one for each planner. Write it once in a plugin, outside of namespaces.
#define WEND_PLANNER_PLUGIN(...)                                                    \
  extern "C" {                                                                      \
  extern WEND_EXPORT const char wend_plugin_version[];                              \
  const char wend_plugin_version[] = WEND_PLUGIN_VERSION_MARK WEND_VERSION;         \
  WEND_EXPORT const void* wend_plugin_library() { return wend::library_mark(); }    \
  WEND_EXPORT void wend_plugin_planners(std::vector<wend::PlannerInfo>* planners) { \
    for (const auto make : {__VA_ARGS__}) planners->push_back(make());              \
  }                                                                                 \
  }

namespace wend {

/// The same address for all who share one copy of the library in a process.
WEND_API const void* library_mark();

}  // namespace wend
