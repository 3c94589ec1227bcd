#pragma once

// Comparison: how planners did on the same queries, one or many, for people and for programs.
//
// Many queries are compared by statistics: the median, the mean and the 99th percentile over the
// queries that every planner solved, so that all are measured on the same queries. A percentile is
// one of the values, by nearest rank (see statistics.hpp). 99 of 100 queries do not exceed the 99th.
// Where more is better, as for the clearance, it is the 1st: 1 of 100 queries lies below it.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/comparison/timed_planner.hpp"
#include "wend/base/status.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/planner/failure.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

/// What a planner is asked, in grid coordinates.
struct EasedEnds {
  Pose start;
  std::vector<Goal> goals;
};

/// One planner on one query. Without a path, the values that describe it are meaningless.
struct ComparisonRow {
  std::string planner;  // as it was typed: "astar:weight=2"
  Status status = Status::found;
  std::string reason = {};          // of a failure, for people
  Failure failure = {};             // the same as data; empty if there is no planner
  double cost = 0;                  // as in Plan::cost; for a car, its fuel
  double length = 0;                // cells
  double turning = 0;               // degrees, all turns together
  double largest_curvature = 0;     // 1 / cells; corners rounded by kCornerRounding
  double smallest_clearance = 0;    // cells; infinite without obstacles
  double mean_clearance = 0;        // the same, over the path's length
  std::uint64_t steps = 0;          // moves
  std::uint64_t reversals = 0;      // how often a car changes between forward and reverse
  bool counts_first_query = false;  // the next three: later queries find their answer kept
  std::uint64_t expanded = 0;
  std::uint64_t generated = 0;
  std::uint64_t max_frontier = 0;  // the largest number of open states
  QueryTimes times{};
  EasedEnds eased{};                 // the query without what the robot could not do
  Path lead{};                       // the way out before what the planner was asked for
  std::vector<std::string> notes{};  // a sentence for each end that was moved or led out
  std::optional<double> remaining =
      {};  // cells from the path's end to the nearest goal, if that was asked for

  bool found() const { return status == Status::found; }
};

/// What was asked, in grid coordinates.
struct ComparedQuery {
  Pose start;
  std::vector<Goal> goals;          // one or more
  std::vector<ComparisonRow> rows;  // one a planner, in the same order in every query
};

struct Comparison {
  Frame frame;
  std::vector<ComparedQuery> queries;
  Capabilities capabilities{};     // of the first planner; all have the same states
  std::string cost_name = "cost";  // what its cost is called
};

/// For people. For one query: a line for each planner about its path, then one about its search, then
/// why some found nothing; tables that are too wide continue below. For many: a block for each
/// measure, with a line for each planner. At most `width` columns (80 or more) unless an option in a planner's
/// name is longer than 24 characters. The best values are marked, unless all are equal; only planners that
/// found a path compete. Lengths are in the user's unit, metres or cells. Cars are also compared by
/// steps and reversals.
std::string comparison_table(const Comparison& comparison, std::size_t width = 80);

/// {"schema", "queries": [{"start", "goal", "planners": [{"planner", "status", "cost",
/// "length_cells", "length_m", "turning_degrees", "curvature_per_cell", "curvature_per_m",
/// "turning_radius_cells", "turning_radius_m", "clearance_cells", "clearance_m",
/// "mean_clearance_cells", "mean_clearance_m", "metrics", "times": {"preparation_us", "first_query_us", "later_query_us"}}]}],
/// "solved_by_all", "statistics": [{"planner", "solved", "cost_ratio": {"median", "mean", "p99"},
/// ...}]}; clearances and the turning radius have "p1" instead of "p99". A failure has a "reason".
/// Its unknown values are null, as are infinite values.
/// `cost_ratio` is to the cheapest cost that any planner found. A query with several goals has "goals", a
/// list, instead of "goal"; where the ends were eased (Leeway), a planner has "notes", and "remaining_cells" and
/// "remaining_m"; one with tolerances has "goal_tolerance_cells". Start and goal are cells [x,y];
/// for cars they are [x,y,"E"] in grid coordinates (a heading that is not one of the four is in
/// radians; "any": any heading), and rows also have "steps" and "reversals". One line with its line
/// end.
std::string comparison_json(const Comparison& comparison);

/// A line for each query and planner with the same columns, after a line of their names. Fields that
/// mean nothing for a failure are empty; "inf" is infinite. The coordinates of several goals are separated by
/// semicolons. Quotes as in RFC 4180.
std::string comparison_csv(const Comparison& comparison);

}  // namespace wend
