#include "wend/report/plan_json.hpp"

#include "wend/geometry/angle.hpp"
#include "wend/report/drive_commands.hpp"
#include "wend/report/path_json.hpp"

namespace wend {
namespace {

Json json_of(const SnappingError& error, const Frame& frame) {
  return {{"cells", error.distance},
          {"m", error.distance * frame.resolution},
          {"degrees", degrees_from(error.turn)}};
}

}  // namespace

std::string plan_json(const PlanResult& result, const Frame& frame, std::span<const Layer> layers) {
  Json json{{"planner", result.planner}, {"status", to_string(result.status)}};
  if (result.status != Status::found) json["reason"] = result.reason;
  put_path(json, result.plan, frame, result.motion);
  if (result.refined) put_refined(json, *result.refined, frame);
  json["bound"] = result.plan.bound;
  if (result.motion == Motion::car) {
    const bool found = !result.plan.path.empty();
    json["start_shift"] = found ? json_of(result.plan.start_snapping_error, frame) : Json();
    json["goal_shift"] = found ? json_of(result.plan.goal_snapping_error, frame) : Json();
    json["steps_in_reverse"] = found ? Json(steps_in_reverse(result.plan)) : Json();
    json["turning_radius_cells"] = result.unit;
    json["turning_radius_m"] = result.unit * frame.resolution;
    json["states"] = result.states;
  }
  json["metrics"] = json_of(result.plan.metrics);
  json["times"] = json_of(result.times);
  for (const Layer& layer : layers) {
    json["layers"][std::string(choice_name(layer.kind))] =
        layer.numbers.empty() ? json_of(layer.arrows) : json_of(layer.numbers);
  }
  return text_of(json);
}

}  // namespace wend
