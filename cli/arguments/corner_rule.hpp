#pragma once

// --corner-rule where no planner has it among its options.

#include "cli/arguments/parser.hpp"
#include "wend/analysis/cost_to_go.hpp"

namespace wend::cli {

/// --corner-rule none|one|both
void add_corner_rule(Parser& app, CornerRule& rule);

}  // namespace wend::cli
