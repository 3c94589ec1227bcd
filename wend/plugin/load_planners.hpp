#pragma once

// load_planners: planners from a shared object, a plugin (wend/plugin/planner_plugin.hpp).
//
//   const auto names = wend::load_planners("libswirl.so");
//   if (!names) return report(names.error().message);

#include <filesystem>
#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"

namespace wend {

/// Loads a plugin and adds its planners, for the whole program: add_planners(). Returns their names. The
/// plugin stays loaded. Its code runs with all rights of the program: load only what you trust.
///
/// Fails with invalid_file, and adds none, if the file does not exist or is not a plugin, if it was compiled
/// for another version of wend or uses another copy of the library than this program, or if add_planners()
/// refuses one of its planners.
WEND_API Expected<std::vector<std::string>, Error> load_planners(
    const std::filesystem::path& plugin);

}  // namespace wend
