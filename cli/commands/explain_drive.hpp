#pragma once

// wend explain --planner hybrid_astar: why there is no drive, and what would make one.

#include <string>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

struct DriveQuestion {
  PlannerSpec planner;  // hybrid_astar
  std::string start;
  std::string goal;
  Format format = Format::text;
  const PictureArguments& pictures;
  const OutputFiles& output;
};

/// Prints and writes the answer. Throws InputError for an end outside the map, and for options that are not the
/// planner's.
ExitCode explain_drive(const DriveQuestion& question, const FreeSpace& space,
                       const Coordinates& coordinates);

}  // namespace wend::cli
