#include "wend/report/field_report.hpp"

#include <array>
#include <cmath>

#include "wend/base/parse.hpp"
#include "wend/report/json.hpp"

namespace wend {
namespace {

Json json_of_start(const FieldStart& from, const Frame& frame) {
  Json json{{"start", json_of(from.start)}, {"status", to_string(from.result.status)}};
  if (from.result.status != Status::found) json["reason"] = from.result.reason;
  put_path(json, from.result.plan, frame);
  return json;
}

Json json_of_grid(const CostToGo& field) {
  const Grid<double>& costs = field.costs();
  Json cost_rows = Json::array();
  Json policy_rows = Json::array();
  for (int y = 0; y < costs.height(); ++y) {
    Json cost_row = Json::array();
    Json policy_row = Json::array();
    for (int x = 0; x < costs.width(); ++x) {
      cost_row.push_back(costs[{x, y}]);
      const auto move = field.policy({x, y});
      policy_row.push_back(move ? Json(to_string(*move)) : Json());
    }
    cost_rows.push_back(std::move(cost_row));
    policy_rows.push_back(std::move(policy_row));
  }
  return {{"width", costs.width()},
          {"height", costs.height()},
          {"costs", std::move(cost_rows)},
          {"policy", std::move(policy_rows)}};
}

}  // namespace

std::string field_json(const FieldReport& report, const Frame& frame, const CostToGo* grid) {
  Json json{{"goals", json_of(report.goals)}, {"status", to_string(report.status)}};
  if (report.status != Status::found) json["reason"] = report.reason;
  json["metrics"] = json_of(report.metrics, report.seconds);
  Json& starts = json["starts"] = Json::array();
  for (const FieldStart& start : report.starts) starts.push_back(json_of_start(start, frame));
  if (grid != nullptr) json["grid"] = json_of_grid(*grid);
  return text_of(json);
}

std::string field_csv(const CostToGo& field) {
  const Grid<double>& costs = field.costs();
  std::string csv = "x,y,cost,move\n";
  for (int y = 0; y < costs.height(); ++y) {
    for (int x = 0; x < costs.width(); ++x) {
      const double cost = costs[{x, y}];
      const auto move = field.policy({x, y});
      csv += std::to_string(x) + "," + std::to_string(y) + ",";
      if (std::isfinite(cost)) csv += format_number(cost);
      csv += ",";
      if (move) csv += to_string(*move);
      csv += "\n";
    }
  }
  return csv;
}

std::string_view to_string(Direction direction) {
  static constexpr std::array<std::string_view, kDirections> kNames{
      "down", "down_right", "right", "up_right", "up", "up_left", "left", "down_left"};
  return kNames[static_cast<std::size_t>(direction)];
}

}  // namespace wend
