#include "docs/planner_page/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "docs/planner_page/benchmark_maps.hpp"
#include "wend/analysis/layer.hpp"
#include "wend/geometry/corner_pose.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/picture/drawing.hpp"

namespace wend::planner_page {
namespace {

constexpr int kWidth = 79;
constexpr int kHeight = 47;
constexpr std::uint64_t kPictureSeed = 4;
constexpr Cell kStart{4, 23};
constexpr Cell kGoal{69, 23};
constexpr int kLotWidth = 60;
constexpr int kLotHeight = 40;

std::string expanded_in_words(const PlannerInfo& info, const Plan& plan,
                              const SearchRecorder& recorder) {
  if (info.capabilities.headings) return fmt::format("{} poses expanded", plan.metrics.expanded);
  if (info.index_support) return "answered by the index, no cells expanded";
  const auto& orders = recorder.layers().expansion.values();
  const auto cells = std::ranges::count_if(orders, [](std::uint32_t order) { return order > 0; });
  if (plan.metrics.expanded == static_cast<std::uint64_t>(cells)) {
    return fmt::format("{} cells expanded", cells);
  }
  return fmt::format("{} expansions of {} cells", plan.metrics.expanded, cells);
}

std::string caption_of(const PlannerInfo& info, const Plan& plan, Status status,
                       const SearchRecorder& recorder) {
  const std::string expanded = expanded_in_words(info, plan, recorder);
  if (status != Status::found) return fmt::format("{}; {}.", expanded, describe(status));
  return fmt::format("{}; path cost {:.1f}.", expanded, plan.cost);
}

/// The query of a picture.
struct PictureQuery {
  FreeSpace space;
  Query query;
  Scene scene;
};

PictureQuery between_rooms() {
  const FreeSpace space = *make_free_space(
      generated_map("rooms", kWidth, kHeight, kPictureSeed, {{"room_size", "11"}}));
  return {space, Query::between(kStart, kGoal), scene_between(space, kStart, kGoal)};
}

PictureQuery across_a_parking_lot() {
  const FreeSpace space =
      *make_free_space(generated_map("parking", kLotWidth, kLotHeight, kPictureSeed));
  const Pose start = pose_of({{0, 0}, Heading::plus_x});
  const Pose goal = pose_of({{kLotWidth, kLotHeight}, Heading::plus_x});
  Scene scene{.space = space};
  scene.start = start;
  scene.goals = {goal};
  scene.places = corners_of(space);
  return {space, {start, {goal}}, std::move(scene)};
}

Expected<Picture, Error> picture_of(const PlannerInfo& info) {
  PictureQuery asked =
      info.capabilities.vertices == Vertices::corners ? across_a_parking_lot() : between_rooms();
  OptionValues options;
  if (info.capabilities.primitives) options = {{"turning_radius", "2"}};
  const auto planner = info.make(asked.space, options);
  if (!planner) return failure(planner.error().status, info.name + ": " + planner.error().message);
  SearchRecorder recorder(asked.space, asked.scene.places);
  asked.query.observer = &recorder;
  Plan plan;
  const Status status = (*planner)->plan(asked.query, plan);

  Scene& scene = asked.scene;
  scene.path = plan.path;
  scene.heatmap = {"order of expansion",
                   search_layer(LayerKind::expansion, **planner, recorder).numbers};
  auto png = draw_png(scene);
  if (!png) return Unexpected<Error>(png.error());
  return Picture{info.name, *std::move(png), caption_of(info, plan, status, recorder)};
}

}  // namespace

Expected<std::vector<Picture>, Error> pictures_of_planners() {
  std::vector<Picture> pictures;
  for (const PlannerInfo& info : planners()) {
    auto picture = picture_of(info);
    if (!picture) return Unexpected<Error>(picture.error());
    pictures.push_back(*std::move(picture));
  }
  return pictures;
}

std::string about_pictures() {
  return fmt::format(
      "The pictures show one query from left to right, on rooms of {} x {} cells (lattice has a "
      "turning radius of 2 cells there), and for the car on a parking lot of {} x {} cells. "
      "Colours show the order of expansion, from light to dark; "
      "white cells were not expanded.",
      kWidth, kHeight, kLotWidth, kLotHeight);
}

}  // namespace wend::planner_page
