#include "wend/report/no_path_json.hpp"

#include "wend/base/status.hpp"
#include "wend/report/json.hpp"

namespace wend {
namespace {

Json json_of(const WidestPath& widest, const Frame& frame) {
  Json json{{"radius_cells", widest.radius},
            {"radius_m", nullptr},
            {"narrowest", Json::array({widest.narrowest.x, widest.narrowest.y})},
            {"narrowest_m", nullptr}};
  if (frame.metric) {
    const Point metres = frame.to_metres(widest.narrowest);
    json["radius_m"] = widest.radius * frame.resolution;
    json["narrowest_m"] = Json::array({metres.x, metres.y});
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

std::string no_path_json(const NoPath& why, const Frame& frame) {
  Json json{{"status", to_string(why.path_exists() ? Status::found : Status::unreachable)},
            {"start_region", why.start_component},
            {"goal_region", why.goal_component},
            {"widest", why.widest ? json_of(*why.widest, frame) : Json()}};
  Json& ways = json["ways"] = Json::array();
  for (const Way& way : why.ways) ways.push_back(json_of(way, frame));
  return text_of(json);
}

}  // namespace wend
