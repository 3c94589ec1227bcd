#include "wend/report/path_json.hpp"

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

Json json_of_smoothing(const RefinedPath& path) {
  const auto& smoothing = path.refined.smoothing;
  if (!smoothing || !path.wanted.smoother) return {};
  return {{"smoother", path.wanted.smoother->name}, {"sweeps", smoothing->sweeps},
          {"converged", smoothing->converged},      {"held", smoothing->held},
          {"returned", smoothing->returned},        {"within_bound", smoothing->within_bound}};
}

}  // namespace

Json json_of(const MeasuredPath& path, const Frame& frame) {
  const PathMetrics& metrics = path.metrics;
  const double metre = frame.resolution;
  return {{"points", path.points},
          {"length_cells", metrics.length},
          {"length_m", metrics.length * metre},
          {"turning_degrees", degrees_from(metrics.turning)},
          {"smallest_turning_radius_cells", metrics.smallest_turning_radius},
          {"smallest_turning_radius_m", metrics.smallest_turning_radius * metre},
          {"rounded_turning_radius_cells", metrics.rounded_turning_radius},
          {"rounded_turning_radius_m", metrics.rounded_turning_radius * metre},
          {"corner_rounding_cells", metrics.corner_rounding},
          {"corner_rounding_m", metrics.corner_rounding * metre},
          {"smallest_clearance_cells", metrics.smallest_clearance},
          {"smallest_clearance_m", metrics.smallest_clearance * metre},
          {"mean_clearance_cells", metrics.mean_clearance},
          {"mean_clearance_m", metrics.mean_clearance * metre},
          {"reversals", metrics.reversals}};
}

Json waypoints_of(const Path& path) {
  Json json = Json::array();
  for (const Point point : path.points()) json.push_back(Json::array({point.x, point.y}));
  return json;
}

Json points_in_metres(const Path& path, const Frame& frame) {
  Json json = Json::array();
  for (const Point point : path.points_in_metres(frame)) {
    json.push_back(Json::array({point.x, point.y}));
  }
  return json;
}

void put_paths(Json& json, const RefinedPath& path, const Frame& frame) {
  if (!path.before.cells().empty()) {
    json["path"] = json_of(path.before.cells());
    json["path_m"] = points_in_metres(path.before, frame);
  }
  put_refined(json, path, frame);
}

void put_refined(Json& json, const RefinedPath& path, const Frame& frame) {
  json["path_smoothed"] = waypoints_of(path.refined.path);
  json["path_smoothed_m"] = points_in_metres(path.refined.path, frame);
  json["smoothing"] = json_of_smoothing(path);
  json["path_metrics"] = json_of(path.measured_before, frame);
  json["path_smoothed_metrics"] = json_of(path.measured_after, frame);
}

}  // namespace wend
