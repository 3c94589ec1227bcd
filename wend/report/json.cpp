#include "wend/report/json.hpp"

#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/path/gears.hpp"
#include "wend/search/search_metrics.hpp"

namespace wend {
namespace {

constexpr double kMostExact = 9007199254740992;  // 2^53: whole numbers up to it are themselves

void put_poses(Json& json, const Plan& plan, const Frame& frame) {
  Json corners = Json::array();
  Json headings = Json::array();
  Json metres = Json::array();
  Json yaws = Json::array();
  for (const Pose& pose : plan.path.poses()) {
    const MapPose in_map = frame.to_metres(pose);
    corners.push_back(json_of(pose.point()));
    headings.push_back(json_of_heading(pose.heading, frame));
    metres.push_back(json_of_fractions(in_map.point()));
    yaws.push_back(in_map.heading);
  }
  json.update({{"path", corners},
               {"headings", headings},
               {"moves", plan.moves},
               {"path_m", metres},
               {"yaw", yaws}});
}

template <class T, class JsonOf>
Json rows_of(const Grid<T>& grid, const JsonOf& json_of_value) {
  Json rows = Json::array();
  for (int y = 0; y < grid.height(); ++y) {
    Json& row = rows.emplace_back(Json::array());
    for (const T& value : grid.row(y)) row.push_back(json_of_value(value));
  }
  return rows;
}

template <class PointType>
Json json_of_all(const std::vector<PointType>& points) {
  Json json = Json::array();
  for (const PointType point : points) json.push_back(json_of_fractions(point));
  return json;
}

}  // namespace

Json json_of(Point point) {
  const auto number = [](double value) {
    const bool whole = value == std::round(value) && std::abs(value) <= kMostExact;
    return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
  };
  return Json::array({number(point.x), number(point.y)});
}

Json json_of_heading(double radians, const Frame& frame) {
  const auto heading = exact_heading(radians);
  return heading ? Json(letter_of(*heading, frame)) : Json(radians);
}

Json json_of_fractions(Point point) { return Json::array({point.x, point.y}); }
Json json_of_fractions(MapPoint point) { return Json::array({point.x, point.y}); }

Json json_of(const std::vector<Point>& points) { return json_of_all(points); }
Json json_of(const std::vector<MapPoint>& points) { return json_of_all(points); }

Json json_of(Cell cell) { return Json::array({cell.x, cell.y}); }

Json json_of(std::span<const Cell> cells) {
  Json json = Json::array();
  for (const Cell cell : cells) json.push_back(json_of(cell));
  return json;
}

Json json_of(const Grid<double>& numbers) {
  return rows_of(numbers, [](double number) { return Json(number); });
}

Json json_of(const Grid<std::optional<Direction>>& directions, const Frame& frame) {
  return rows_of(directions, [&frame](const std::optional<Direction>& direction) {
    return direction ? Json(name_of(*direction, frame)) : Json();
  });
}

void put_shifts(Json& json, const Plan& plan, const Frame& frame) {
  const bool found = !plan.path.empty();
  const auto shift = [&](const SnappingError& error) -> Json {
    if (!found) return {};
    return {{"cells", error.distance},
            {"m", error.distance * frame.resolution},
            {"degrees", degrees_from(error.turn)}};
  };
  json["start_shift"] = shift(plan.start_snapping_error);
  json["goal_shift"] = shift(plan.goal_snapping_error);
}

Json json_of(const SearchMetrics& metrics) {
  Json json;
  for (const Metric& metric : metrics_of(metrics)) put(json, metric, {});
  return json;
}

void put(Json& json, const Metric& metric, const Frame& frame) {
  const std::string name(metric.name);
  switch (metric.unit) {
    case MetricUnit::cells:
      json[name + "_cells"] = metric.value;
      json[name + "_m"] = metric.in_metres(frame.resolution);
      return;
    case MetricUnit::radians:
      json[name + "_degrees"] = degrees_from(metric.value);
      return;
    case MetricUnit::count:
      json[name] = static_cast<std::uint64_t>(metric.value);
  }
}

Json in_microseconds(double seconds) {
  const double nanoseconds = std::round(seconds * 1e9);
  return nanoseconds / 1000;
}

Json json_of(const WorkTimes& times) {
  const auto optional = [](const std::optional<double>& seconds) {
    return seconds ? in_microseconds(*seconds) : Json();
  };
  return {{"load_us", in_microseconds(times.load)},
          {"free_space_us", in_microseconds(times.free_space)},
          {"planner_us", optional(times.planner)},
          {"index_us", optional(times.index)},
          {"search_us", in_microseconds(times.search)}};
}

Json json_of(const OptionInfo& option) {
  Json json{{"name", option.name}};
  json["aliases"] = option.aliases;
  json["kind"] = to_string(option.kind);
  json["default"] = option.default_value;
  if (option.kind == OptionKind::choice) json["choices"] = option.choices;
  if (option.kind == OptionKind::integer || option.kind == OptionKind::number) {
    json["least"] = option.least;
    json["greatest"] = option.greatest;
  }
  json["help"] = option.help;
  return json;
}

void put_eased(Json& json, const std::optional<LeadOut>& lead_out,
               const std::optional<double>& remaining, const Frame& frame) {
  if (lead_out) {
    json["lead_out"] = {{"length_cells", lead_out->length / frame.resolution},
                        {"length_m", lead_out->length},
                        {"points", lead_out->points},
                        {"reason", lead_out->reason}};
  }
  if (remaining) {
    json["remaining"] = {{"cells", *remaining / frame.resolution}, {"m", *remaining}};
  }
}

void put_path(Json& json, const Plan& plan, const Frame& frame, const Capabilities& capabilities) {
  const bool found = !plan.path.empty();
  const double length = plan.path.length();
  json["cost"] = found ? Json(plan.cost) : Json();
  json["length_cells"] = found ? Json(length) : Json();
  json["length_m"] = found ? Json(length * frame.resolution) : Json();
  if (capabilities.headings) {
    json["steps"] = found ? Json(plan.path.size() - 1) : Json();
    put_poses(json, plan, frame);
    put_driven(json, plan.path, frame);
    return;
  }
  put_joints(json, plan.path, frame);
}

void put_joints(Json& json, const Path& path, const Frame& frame) {
  const bool waypoints = !path.waypoints().empty() && !path.leads_over_cells();
  json["path"] = waypoints ? json_of(path.points()) : json_of(path.passed_cells());
  if (waypoints) json["waypoints"] = true;
  json["path_m"] = json_of(path.points_in_metres(frame));
}

void put_driven(Json& json, const Path& path, const Frame& frame) {
  Json poses = Json::array();
  for (const Pose& pose : path.driven_poses()) {
    const MapPose in_map = frame.to_metres(pose);
    poses.push_back({in_map.x, in_map.y, in_map.heading});
  }
  json["poses_m"] = std::move(poses);
  json["gears"] = path.driven() ? Json(gears_of(path)) : Json::array();
}

std::string text_of(const Json& report) {
  Json json{{"schema", kJsonSchema}};
  if (report.is_object()) json.update(report);
  return (report.is_object() ? json : report).dump(-1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

}  // namespace wend
