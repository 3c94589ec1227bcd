#pragma once

// Explanations in the words of the command line: the library's sentences with the names of the options.

#include <string>
#include <string_view>

#include "cli/arguments/coordinates.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/explainer.hpp"

namespace wend::cli {

/// What explanations call the options of the command line.
Hints command_line_hints();

/// "widest path       robot with a radius ...", folded at the width of the terminal (80 columns elsewhere) with a hanging indent.
std::string explanation_line(std::string_view name, const std::string& what);

/// Explains in the user's units, for a planner that moves so.
Explainer explainer_for(const FreeSpace& space, const Coordinates& coordinates, GridMoves moves);

}  // namespace wend::cli
