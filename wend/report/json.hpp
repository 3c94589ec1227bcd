#pragma once

// Common code of the JSON reports. Include it only in sources: the headers of the reports do not need a
// JSON library.

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/base/metric.hpp"
#include "wend/base/options.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/grid.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/report/path_report.hpp"
#include "wend/report/plan_report.hpp"
#include "wend/report/trajectory_report.hpp"

namespace wend {

/// Keys stay in the order in which they were written.
using Json = nlohmann::ordered_json;

/// [x, y]
Json json_of(Cell cell);

/// [x, y] of a point in grid coordinates: [3, 4] for a corner, else [2.5, 4.0].
Json json_of(Point point);

/// [x, y], [[x, y], ...]: all numbers have a fraction.
Json json_of_fractions(Point point);
Json json_of_fractions(MapPoint point);
Json json_of(const std::vector<Point>& points);
Json json_of(const std::vector<MapPoint>& points);

/// A letter such as "E" for one of the four headings, else radians in grid coordinates.
Json json_of_heading(double radians, const Frame& frame);

/// [[x, y], ...]
Json json_of(std::span<const Cell> cells);

/// A list of rows, row 0 first. Numbers that are not finite are null.
Json json_of(const Grid<double>& numbers);

/// The same for directions, by name; null for a cell without one.
Json json_of(const Grid<std::optional<Direction>>& directions, const Frame& frame);

/// {"name", "aliases", "kind", "default", "choices" or "least" and "greatest", "help"}
Json json_of(const OptionInfo& option);

/// "start_shift" and "goal_shift", {"cells", "m", "degrees"} from what was asked; null without a path.
void put_shifts(Json& json, const Plan& plan, const Frame& frame);

/// A metric under its name: a length with "_cells" and with "_m", an angle with "_degrees".
void put(Json& json, const Metric& metric, const Frame& frame);

/// {"expanded", "generated", "max_frontier"}
Json json_of(const SearchMetrics& metrics);

/// Microseconds to the nanosecond; null if not finite.
Json in_microseconds(double seconds);

/// {"load_us", "free_space_us", "planner_us", "index_us", "search_us"}; null for steps that did not occur.
Json json_of(const WorkTimes& times);

/// "lead_out" and "remaining", each where there is one; see plan_report.hpp.
void put_eased(Json& json, const std::optional<LeadOut>& lead_out,
               const std::optional<double>& remaining, const Frame& frame);

/// "cost", "length_cells", "length_m", "path", "path_m" of a plan; without a path, null and empty.
/// For planners with headings also "steps", "headings", "moves", "yaw", "poses_m" and "gears", as in
/// plan_json().
void put_path(Json& json, const Plan& plan, const Frame& frame,
              const Capabilities& capabilities = {});

/// "path" and "path_m" of a path of cells; of waypoints, also "waypoints": true.
void put_joints(Json& json, const Path& path, const Frame& frame);

/// "poses_m" and "gears" of a path of poses, as in plan_json(); empty lists for other paths.
void put_driven(Json& json, const Path& path, const Frame& frame);

// JSON of path_report.hpp: the lengths of a path, what smoothing_json() has besides the original path, and
// the original path too.
Json json_of(const MeasuredPath& path, const Frame& frame);
void put_refined(Json& json, const RefinedPath& path, const Frame& frame);
void put_paths(Json& json, const RefinedPath& path, const Frame& frame);

/// The "trajectory" of trajectory_json().
Json json_of(const SampledTrajectory& sampled);

/// The number of the schema that every report has as its first key, "schema". It grows when a key is
/// renamed, removed or changes its meaning; not when one is added (docs/compatibility.md).
inline constexpr int kJsonSchema = 1;

/// A report: one line that begins with its "schema", unless the report is a list. Numbers that JSON
/// cannot express are null, invalid UTF-8 is replaced.
std::string text_of(const Json& report);

}  // namespace wend
