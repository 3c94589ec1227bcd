#include "docs/planner_page/pictures.hpp"

#include <fmt/format.h>

#include "docs/planner_page/generated_families.hpp"
#include "wend/planner/layer.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/drawing.hpp"

namespace wend::planner_page {
namespace {

constexpr int kWidth = 79;
constexpr int kHeight = 47;
constexpr std::uint64_t kSeed = 4;
constexpr Cell kStart{4, 23};
constexpr Cell kGoal{69, 23};

FreeSpace space_of_pictures() {
  return FreeSpace(generated_map("rooms", kWidth, kHeight, kSeed, {{"room_size", "11"}}));
}

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

Expected<Picture, RenderError> picture_of(const PlannerInfo& info, const FreeSpace& space) {
  const auto planner = info.make(space, {});
  if (!planner) return Unexpected<RenderError>({info.name + ": " + planner.error().message()});
  SearchRecorder recorder(space);
  Query query = Query::between(kStart, kGoal);
  query.observer = &recorder;
  Plan plan;
  const Status status = (*planner)->plan(query, plan);

  Scene scene = scene_between(space, kStart, kGoal);
  scene.path = plan.path;
  scene.heatmap = {"order of expansion",
                   search_layer(LayerKind::expansion, **planner, recorder).numbers};
  auto png = draw_png(scene);
  if (!png) return Unexpected<RenderError>(png.error());
  return Picture{info.name, *std::move(png), caption_of(plan, status, recorder)};
}

}  // namespace

Expected<std::vector<Picture>, RenderError> pictures_of_planners() {
  const FreeSpace space = space_of_pictures();
  std::vector<Picture> pictures;
  for (const PlannerInfo& info : planners()) {
    auto picture = picture_of(info, space);
    if (!picture) return Unexpected<RenderError>(picture.error());
    pictures.push_back(*std::move(picture));
  }
  return pictures;
}

std::string about_pictures() {
  return fmt::format(
      "The pictures show the same question on the same map: rooms, {} x {} cells, from left to "
      "right. The colours are the order of expansion, from light (first) to dark (last); white "
      "cells were never expanded.",
      kWidth, kHeight);
}

}  // namespace wend::planner_page
