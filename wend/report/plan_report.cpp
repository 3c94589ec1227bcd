#include "wend/report/plan_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>

#include "wend/report/json.hpp"
#include "wend/robot/repeated_moves.hpp"

namespace wend {
namespace {

Json json_of(const std::vector<TimedSolution>& solutions) {
  constexpr double kMicroseconds = 1e6;
  Json list = Json::array();
  for (const TimedSolution& solution : solutions) {
    list.push_back({{"search_us", kMicroseconds * solution.seconds},
                    {"cost", solution.cost},
                    {"bound", solution.bound},
                    {"expanded", solution.expanded}});
  }
  return list;
}

}  // namespace

std::string plan_json(const PlanResult& result, const Frame& frame, std::span<const Layer> layers) {
  Json json{{"planner", result.planner}, {"status", to_string(result.status)}};
  if (result.status != Status::found) json["reason"] = result.reason;
  put_path(json, result.plan, frame, result.capabilities);
  if (result.refined) put_refined(json, *result.refined, frame);
  if (result.trajectory) json["trajectory"] = json_of(*result.trajectory);
  json["bound"] = result.plan.bound;
  if (result.status == Status::found) {
    put_eased(json, result.lead_out, result.remaining, frame);
  }
  const bool found = !result.plan.path.empty();
  put_shifts(json, result.plan, frame);
  if (result.capabilities.headings) {
    json["steps_in_reverse"] = found ? Json(steps_in_reverse(result.plan)) : Json();
    if (result.places.on_corners()) {
      json["turning_radius_cells"] = result.places.spacing;
      json["turning_radius_m"] = result.places.spacing * frame.resolution;
    }
    json["states"] = result.states;
  }
  json["robot_radius"] = result.footprint.circumscribed_radius();
  json["footprint"] = text_of(result.footprint);
  json["notes"] = result.notes;
  json["metrics"] = json_of(result.plan.metrics);
  json["times"] = json_of(result.times);
  if (result.anytime) json["solutions"] = json_of(result.solutions);
  for (const Layer& layer : layers) {
    json["layers"][std::string(choice_name(layer.kind))] =
        layer.numbers.empty() ? json_of(layer.arrows, frame) : json_of(layer.numbers);
  }
  return text_of(json);
}

std::string drive_commands(const Plan& plan, const Frame& frame) {
  if (plan.path.empty()) return {};
  const std::vector<Pose> poses = plan.path.poses();
  assert(plan.moves.size() + 1 == poses.size());
  std::string text = "Start " + pose_text(poses.front(), frame) + "\n";
  for (const RepeatedMove& move : merged_moves(plan.moves)) {
    fmt::format_to(std::back_inserter(text), "Go {} -> {}\n", text_of(move),
                   pose_text(poses[move.end], frame));
  }
  return text;
}

std::size_t steps_in_reverse(const Plan& plan) {
  const auto count = std::ranges::count_if(
      plan.moves, [](std::string_view name) { return name.starts_with("REV"); });
  return static_cast<std::size_t>(count);
}

}  // namespace wend
