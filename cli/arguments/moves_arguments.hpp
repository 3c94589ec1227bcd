#pragma once

// --connectivity and --corner-rule where no planner has them among its options.

#include "cli/arguments/parser.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

struct MovesArguments {
  GridMoves moves;

  void add_to(Parser& app);
};

}  // namespace wend::cli
