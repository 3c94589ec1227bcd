#include "wend/report/analysis_report.hpp"

#include <cmath>

#include "wend/base/parse.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/report/json.hpp"
#include "wend/session/failure_text.hpp"

namespace wend {
namespace {

Json json_of_start(const FieldStart& from, const Frame& frame) {
  Json json{{"start", json_of(from.start)}, {"status", to_string(from.result.status)}};
  if (from.result.status != Status::found) json["reason"] = from.result.reason;
  put_path(json, from.result.plan, frame);
  return json;
}

Json json_of_grid(const CostToGo& field, const Frame& frame) {
  const Grid<double>& costs = field.costs();
  Grid<std::optional<Direction>> policy(costs.width(), costs.height());
  for (const Cell cell : every_cell(policy)) policy[cell] = field.policy(cell);
  return {{"width", costs.width()},
          {"height", costs.height()},
          {"costs", json_of(costs)},
          {"policy", json_of(policy, frame)}};
}

Json json_of(const WidestPath& widest, const Frame& frame) {
  Json json{{"radius_cells", widest.radius},
            {"radius_m", nullptr},
            {"narrowest", json_of_fractions(widest.narrowest)},
            {"narrowest_m", nullptr}};
  if (frame.metric) {
    json["radius_m"] = widest.radius * frame.resolution;
    json["narrowest_m"] = json_of_fractions(frame.to_metres(widest.narrowest));
  }
  return json;
}

Json json_of(const Way& way, const Frame& frame) {
  return {{"unknown_free", way.unknown_free},
          {"squeeze", way.squeeze},
          {"smaller_robot", way.smaller_robot},
          {"widest", json_of(way.widest, frame)}};
}

}  // namespace

std::string field_json(const FieldReport& report, const Frame& frame, const CostToGo* grid) {
  Json json{{"goals", json_of(report.goals)}, {"status", to_string(report.status)}};
  if (report.status != Status::found) json["reason"] = report.reason;
  json["metrics"] = json_of(report.metrics);
  json["times"] = json_of(report.times);
  Json& starts = json["starts"] = Json::array();
  for (const FieldStart& start : report.starts) starts.push_back(json_of_start(start, frame));
  if (grid != nullptr) json["grid"] = json_of_grid(*grid, frame);
  return text_of(json);
}

std::string field_csv(const CostToGo& field, const Frame& frame) {
  std::string csv = "x,y,cost,move\n";
  for (const Cell cell : every_cell(field.costs())) {
    const double cost = field.costs()[cell];
    const auto move = field.policy(cell);
    csv += std::to_string(cell.x) + "," + std::to_string(cell.y) + ",";
    if (std::isfinite(cost)) csv += format_number(cost);
    csv += ",";
    if (move) csv += name_of(*move, frame);
    csv += "\n";
  }
  return csv;
}

std::string no_path_json(const NoPath& why, const Frame& frame) {
  Json json{{"status", to_string(why.path_exists() ? Status::found : Status::unreachable)},
            {"start_region", why.start_component},
            {"goal_region", why.goal_component},
            {"widest", why.widest ? json_of(*why.widest, frame) : Json()}};
  Json& ways = json["ways"] = Json::array();
  for (const Way& way : why.ways) ways.push_back(json_of(way, frame));
  return text_of(json);
}

std::string no_drive_json(const NoDrive& why, const FreeSpace& space) {
  const Frame& frame = space.map().frame();
  Json json{{"status", to_string(why.status)},
            {"reason", why.drive_exists() ? Json() : Json(words_of(why.failure, {}, space))},
            {"widest", why.widest ? json_of(*why.widest, frame) : Json()},
            {"inscribed_radius_cells", space.inscribed_radius_in_cells()},
            {"footprint_scale", nullptr},
            {"turning_radius_cells", nullptr},
            {"turning_radius_m", nullptr},
            {"reverse_helps", nullptr},
            {"expanded", why.expanded}};
  if (why.footprint_scale) json["footprint_scale"] = *why.footprint_scale;
  if (why.turning_radius) json["turning_radius_cells"] = *why.turning_radius / frame.resolution;
  if (why.turning_radius && frame.metric) json["turning_radius_m"] = *why.turning_radius;
  if (why.reverse_helps) json["reverse_helps"] = *why.reverse_helps;
  return text_of(json);
}

}  // namespace wend
