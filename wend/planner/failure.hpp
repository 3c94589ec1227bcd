#pragma once

// Failure: why a query has no path, as data: the ends as the planner took them, and what is so about them.
//
//   const auto plan = planner->plan(query);
//   if (!plan) {
//     for (const wend::FailureCause& cause : plan.error().failure.causes) {
//       if (const auto* blocked = std::get_if<wend::EndBlocked>(&cause)) look_at(blocked->cell);
//     }
//     report(wend::words_of(plan.error(), space));
//   }
//
// words_of() (wend/session/failure_text.hpp) makes sentences of it; an Explainer adds what would help. Lengths are in
// cells, places in grid coordinates.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/limits.hpp"
#include "wend/base/status.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/sweep/contact.hpp"

namespace wend {

/// An end of a query: the index of a goal; nothing: the start.
using EndIndex = std::optional<std::size_t>;

/// Where a path was to begin or end.
struct QueryEnd {
  Point asked;                         // as the query has it
  Point place;                         // of the planner that stands for it; off the map: as asked
  std::optional<double> heading = {};  // there, in radians; nothing: any
};

/// The end is not on the map.
struct EndOutside {
  EndIndex end;  // which
};

/// The robot does not fit at the end.
struct EndBlocked {
  EndIndex end = {};                           // which
  BlockReason reason = BlockReason::obstacle;  // what is so
  std::optional<Cell> cell = {};  // that is blocked, or the one from whose middle `distance` counts
  std::optional<std::string> mask =
      {};                         // the name of the keep-out mask that blocks; empty: it has none
  double distance = 0;            // too_close, over_edge: to the nearest obstacle or edge
  bool fits_beyond_edge = false;  // over_edge: is no obstacle too near as well?
  double radius = 0;              // of the robot; of a polygon: of the disc around it
  std::optional<Contact> contact = {};  // overlaps, leaves: what the polygon touches
  bool at_every_heading = false;        // that was tried; the rest is so at heading 0
};

/// The robot is larger than the map, wherever it stands.
struct RobotTooLarge {
  double width = 0;   // of the box around its footprint, along x
  double height = 0;  // along y
};

/// No path leads from the start to this goal.
struct Separated {
  std::size_t goal;  // which
};

/// No motion primitive leaves the start, or reaches a goal.
struct NoMotion {
  EndIndex end;  // which
};

/// hybrid_astar found no drive to any of the goals.
struct NoDriveFound {
  /// What is known.
  enum class Why {
    parted,          // not even the largest disc within the robot gets from the start to the goal
    goal_boxed_in,   // the same for the whole robot, which is proved near the goal
    start_boxed_in,  // the same near the start
    none_found,      // the searches have ended
  };

  Why why = Why::none_found;      // what is known
  double disc_radius = 0;         // parted: of that disc
  double box = 0;                 // none_found: size of the boxes of which one pose was kept
  int headings = 0;               // the number of boxes of headings
  double step = 0;                // length of a motion
  bool lattice_searched = false;  // is no pose of the lattice of half cells left either?
};

/// A planner's own limit ended the search.
struct OwnLimit {
  std::string planner;  // whose
  std::string option;   // that sets it
  double value;         // of the option
};

/// A limit of the query ended the search, or the cancel flag.
struct Stopped {
  std::uint64_t expansions;  // Limits::expansions
  double seconds;            // Limits::seconds
};

/// The query is not valid.
struct InvalidQuery {
  /// What of it.
  enum class Fault {
    no_goal,        // it has none
    tolerance,      // of a goal is below 0 or NaN
    seconds,        // Limits::seconds is NaN
    heading,        // of an end is not finite
    large_heading,  // of an end is not finite or beyond kLargestHeading
  };

  Fault fault;        // what of it
  EndIndex end = {};  // whose heading
};

/// A sentence of the planner: an index that does not match, or what a planner from outside has to say.
struct OwnText {
  std::string text;  // complete, without a full stop
};

/// One thing that is so.
using FailureCause = std::variant<EndOutside, EndBlocked, RobotTooLarge, Separated, NoMotion,
                                  NoDriveFound, OwnLimit, Stopped, InvalidQuery, OwnText>;

struct Failure {
  Status status = Status::found;     // of the query
  bool headings = false;             // have the planner's states headings?
  PlaceGrid places = {};             // where they lie
  double tolerance = 0;              // of the first goal
  QueryEnd start = {};               // where the path was to begin
  std::vector<QueryEnd> goals = {};  // where it might have ended
  /// What is so: one thing; where several goals cannot be reached, one for each. Empty if the status says it all.
  std::vector<FailureCause> causes = {};

  /// An end of the query.
  const QueryEnd& at(EndIndex end) const { return end ? goals[*end] : start; }
};

/// The error of Planner::plan(). The status is never Status::found. The message says in a few words what the status
/// means, or is the planner's own text; words_of() (wend/session/failure_text.hpp) says where, and what is there.
struct PlanFailure : Error {
  SearchMetrics metrics;  // of the search until then
  Failure failure = {};   // where and why
};

/// What a planner on cells says of a query that ends with this status.
WEND_API Failure failure_in_cells(const FreeSpace& space, const Query& query, Status status);

/// Did a search end at a limit, or because it was cancelled?
WEND_API bool is_limit(Status status);

}  // namespace wend
