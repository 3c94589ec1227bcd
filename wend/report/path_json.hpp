#pragma once

// Paths in JSON reports; see path_report.hpp. Only for the sources of this module, as json.hpp is.

#include "wend/report/json.hpp"
#include "wend/report/path_report.hpp"

namespace wend {

Json json_of(const MeasuredPath& path, const Frame& frame);

/// [[x, y], ...] in grid coordinates.
Json waypoints_of(const Path& path);

/// [[x, y], ...]
Json points_in_metres(const Path& path, const Frame& frame);

/// What smoothing_json() has besides the path as it was, and that too.
void put_refined(Json& json, const RefinedPath& path, const Frame& frame);
void put_paths(Json& json, const RefinedPath& path, const Frame& frame);

}  // namespace wend
