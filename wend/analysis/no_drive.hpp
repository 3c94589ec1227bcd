#pragma once

// NoDrive: why hybrid_astar finds no drive between two poses, as data: the narrowest place of the widest way, the
// largest robot of the same shape and the largest turning radius with which it finds one, and whether reversing helps.
//
// Each answer is that of a planner: the drive for the smaller robot was found, not estimated. The first search is that of
// `plan`, with the limits of the query. The planner is complete only at its resolution, and the searches for what would
// help end at a limit, so a larger robot or radius may do as well.
//
//   const auto why = wend::explain_no_drive(space, query, {.turning_radius = 200});
//   if (why && why->turning_radius) suggest_radius(*why->turning_radius);

#include <cstdint>
#include <optional>

#include "wend/analysis/widest_path.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/status.hpp"
#include "wend/planner/failure.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/se2/hybrid_astar_options.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

struct NoDrive {
  Status status = Status::found;  // of the query as it is asked; found: there is a drive after all
  bool certain = false;           // no drive exists: an end is blocked, or obstacles part them
  Failure failure = {};           // what is so, if there is no drive; Explainer::words() says it

  /// The widest way of a disc from the start to the first goal, through the middles of cells, and its narrowest place.
  /// If its radius is less than that of the robot's inscribed disc by more than half the diagonal of a cell, no drive
  /// exists. Nothing if an end is not on the map, or if not even a point gets through.
  std::optional<WidestPath> widest;

  /// Below 1: the largest scale of the footprint for which a drive was found, to 1 %. Nothing if there was none, and
  /// for a point.
  std::optional<double> footprint_scale;

  /// The largest turning radius below the asked one with which a drive was found, in metres, to 1 %. Nothing if
  /// there was none, if an end is blocked, and for robots that turn in place.
  std::optional<double> turning_radius;

  /// Was a drive found in reverse? Nothing if the robot may reverse already, or if an end is blocked.
  std::optional<bool> reverse_helps;

  std::uint64_t expanded = 0;  // by all searches

  /// Is there a drive after all?
  bool drive_exists() const { return status == Status::found; }
};

/// Plans the query with these options and its own limits, as `plan` does, and, if no drive is found, with changes of
/// them, at most 20 times in all. Each search of a change ends after `expansions`, so the answer depends on time only if
/// the first search does. The observer of the query is not told. If Limits::cancel is set, the status is cancelled.
/// Fails as making the planner does.
WEND_API Expected<NoDrive, Error> explain_no_drive(const FreeSpace& space, const Query& query,
                                                   const HybridAStarOptions& options = {},
                                                   std::uint64_t expansions = 20'000);

}  // namespace wend
