#pragma once

// Coverages as pictures and films: what was covered when, and the path.

#include <string>

#include "wend/base/expected.hpp"
#include "wend/cover/plan_coverage.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend::cli {

/// The map with the path, and the cells coloured by how far the robot had driven when it covered them. What is missed has
/// no colour. `tool_width` in metres.
Scene coverage_scene(const FreeSpace& space, const Coverage& coverage, double tool_width);

/// A GIF of the robot on its way, and of what it has covered.
Expected<std::string, Error> coverage_gif(const FreeSpace& space, const Coverage& coverage,
                                          double tool_width, const Style& style);

}  // namespace wend::cli
