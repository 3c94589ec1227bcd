#include "wend/report/json.hpp"

#include <cmath>

namespace wend {

Json json_of(Cell cell) { return Json::array({cell.x, cell.y}); }

Json json_of(std::span<const Cell> cells) {
  Json json = Json::array();
  for (const Cell cell : cells) json.push_back(json_of(cell));
  return json;
}

Json json_of(const Grid<double>& numbers) {
  Json rows = Json::array();
  for (int y = 0; y < numbers.height(); ++y) {
    Json& row = rows.emplace_back(Json::array());
    for (const double number : numbers.row(y)) row.push_back(number);
  }
  return rows;
}

Json json_of(const Grid<std::optional<Direction>>& directions) {
  Json rows = Json::array();
  for (int y = 0; y < directions.height(); ++y) {
    Json& row = rows.emplace_back(Json::array());
    for (const auto& direction : directions.row(y)) {
      row.push_back(direction ? Json(to_string(*direction)) : Json());
    }
  }
  return rows;
}

Json json_of(const SearchMetrics& metrics, double seconds) {
  const double nanoseconds = std::round(seconds * 1e9);
  return {{"expanded", metrics.expanded},
          {"generated", metrics.generated},
          {"max_frontier", metrics.max_frontier},
          {"time_us", nanoseconds / 1000}};
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

void put_path(Json& json, const Plan& plan, const Frame& frame) {
  const bool found = !plan.path.empty();
  const double length = plan.path.length();
  json["cost"] = found ? Json(plan.cost) : Json();
  json["length_cells"] = found ? Json(length) : Json();
  json["length_m"] = found ? Json(length * frame.resolution) : Json();
  json["path"] = json_of(plan.path.cells());
  Json& metres = json["path_m"] = Json::array();
  for (const Point point : plan.path.points_in_metres(frame)) {
    metres.push_back(Json::array({point.x, point.y}));
  }
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wend
