#include "wend/report/plan_json.hpp"

#include "wend/report/json.hpp"

namespace wend {

std::string plan_json(const PlanResult& result, const Frame& frame, std::span<const Layer> layers) {
  Json json{{"planner", result.planner}, {"status", to_string(result.status)}};
  if (result.status != Status::found) json["reason"] = result.reason;
  put_path(json, result.plan, frame);
  json["bound"] = result.plan.bound;
  json["metrics"] = json_of(result.plan.metrics, result.seconds);
  for (const Layer& layer : layers) {
    json["layers"][std::string(choice_name(layer.kind))] =
        layer.numbers.empty() ? json_of(layer.arrows) : json_of(layer.numbers);
  }
  return text_of(json);
}

}  // namespace wend
