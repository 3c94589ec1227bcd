#include "docs/planner_page/pictures.hpp"

#include <fmt/format.h>

#include <utility>

#include "docs/planner_page/generated_families.hpp"
#include "wend/analysis/layer.hpp"
#include "wend/geometry/car_move.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/picture/drawing.hpp"

namespace wend::planner_page {
namespace {

constexpr int kWidth = 79;
constexpr int kHeight = 47;
constexpr std::uint64_t kSeed = 4;
constexpr Cell kStart{4, 23};
constexpr Cell kGoal{69, 23};
constexpr int kYardWidth = 60;
constexpr int kYardHeight = 40;

std::string caption_of(const Plan& plan, Status status, const SearchRecorder& recorder) {
  std::size_t cells = 0;
  for (const std::uint32_t order : recorder.layers().expansion.values()) cells += order > 0 ? 1 : 0;
  const std::string expanded =
      plan.metrics.expanded == cells
          ? fmt::format("{} cells expanded", cells)
          : fmt::format("{} cells expanded, {} times in all", cells, plan.metrics.expanded);
  if (status != Status::found) return fmt::format("{}; {}.", expanded, describe(status));
  return fmt::format("{}; a path that costs {:.1f}.", expanded, plan.cost);
}

std::string caption_of_drive(const Plan& plan, Status status) {
  const std::string expanded = fmt::format("{} poses expanded", plan.metrics.expanded);
  if (status != Status::found) return fmt::format("{}; {}.", expanded, describe(status));
  return fmt::format("{}; a drive of {} moves that takes {:.1f} of fuel.", expanded,
                     plan.moves.size(), plan.cost);
}

/// What a planner is asked in its picture.
struct Question {
  FreeSpace space;
  Query query;
  Scene scene;
  int unit = 0;  // of a car
};

Question between_rooms() {
  const FreeSpace space(generated_map("rooms", kWidth, kHeight, kSeed, {{"room_size", "11"}}));
  return {space, Query::between(kStart, kGoal), scene_between(space, kStart, kGoal)};
}

Question across_a_parking_yard() {
  const FreeSpace space(generated_map("parking", kYardWidth, kYardHeight, kSeed));
  const bool y_up = space.map().frame().y_up;
  const Pose start = pose_of({{0, 0}, Heading::east}, y_up);
  const Pose goal = pose_of({{kYardWidth, kYardHeight}, Heading::east}, y_up);
  Scene scene{.space = space};
  scene.start = start;
  scene.goals = {goal};
  scene.unit = 1;
  return {space, {start, {goal}}, std::move(scene), 1};
}

Expected<Picture, RenderError> picture_of(const PlannerInfo& info) {
  Question question = info.motion == Motion::car ? across_a_parking_yard() : between_rooms();
  const auto planner = info.make(question.space, {});
  if (!planner) return Unexpected<RenderError>({info.name + ": " + planner.error().message()});
  SearchRecorder recorder(question.space, question.unit);
  question.query.observer = &recorder;
  Plan plan;
  const Status status = (*planner)->plan(question.query, plan);

  Scene& scene = question.scene;
  scene.path = plan.path;
  scene.heatmap = {"order of expansion",
                   search_layer(LayerKind::expansion, **planner, recorder).numbers};
  auto png = draw_png(scene);
  if (!png) return Unexpected<RenderError>(png.error());
  const std::string caption = info.motion == Motion::car ? caption_of_drive(plan, status)
                                                         : caption_of(plan, status, recorder);
  return Picture{info.name, *std::move(png), caption};
}

}  // namespace

Expected<std::vector<Picture>, RenderError> pictures_of_planners() {
  std::vector<Picture> pictures;
  for (const PlannerInfo& info : planners()) {
    auto picture = picture_of(info);
    if (!picture) return Unexpected<RenderError>(picture.error());
    pictures.push_back(*std::move(picture));
  }
  return pictures;
}

std::string about_pictures() {
  return fmt::format(
      "The pictures show the same question on the same map: rooms, {} x {} cells, from left to "
      "right; the car crosses a parking yard, {} x {} cells. The colours are the order of "
      "expansion, from light (first) to dark (last); white cells were never expanded.",
      kWidth, kHeight, kYardWidth, kYardHeight);
}

}  // namespace wend::planner_page
