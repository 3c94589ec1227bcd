#include "cli/output/coverage_scene.hpp"

#include <fmt/format.h>

#include <limits>
#include <vector>

#include "cli/watching/films.hpp"
#include "wend/cover/coverage_times.hpp"
#include "wend/path/polyline.hpp"

namespace wend::cli {
namespace {

constexpr std::size_t kFrames = 120;

std::string in_metres(double length) { return fmt::format("{:.0f} m", length); }

/// The scene as it is after a way of some metres.
Scene scene_after(Scene scene, double driven, double resolution) {
  const double most = driven / resolution;
  const Polyline line(scene.path.waypoints());
  std::vector<Point> points;
  for (std::size_t i = 0; i < line.points().size() && line.along()[i] <= most; ++i) {
    points.push_back(line.points()[i]);
  }
  const Pose robot = line.at(most);
  points.push_back(robot.point());
  scene.path = Path::along(std::move(points));
  scene.robot = robot;
  scene.heatmap->range = range_of(*scene.heatmap);
  for (const Cell cell : every_cell(scene.heatmap->values)) {
    if (scene.heatmap->values[cell] > driven) {
      scene.heatmap->values[cell] = std::numeric_limits<double>::infinity();
    }
  }
  return scene;
}

}  // namespace

Scene coverage_scene(const FreeSpace& space, const Coverage& coverage, double tool_width) {
  Scene scene{.space = space};
  if (coverage.path.empty()) return scene;
  scene = wend::scene_of(space, coverage.path);
  scene.heatmap = {"metres driven", coverage_times(coverage, space, tool_width)};
  return scene;
}

Expected<std::string, Error> coverage_gif(const FreeSpace& space, const Coverage& coverage,
                                          double tool_width, const Style& style) {
  const Scene last = coverage_scene(space, coverage, tool_width);
  const std::string title = "coverage";
  if (coverage.path.size() < 2) return gif_of(title, last, style);
  const double resolution = space.map().frame().resolution;
  const auto panels_at = [&](std::size_t frame) {
    const double driven = coverage.length * static_cast<double>(frame) / (kFrames - 1);
    return std::vector<FilmPanel>{
        {title, in_metres(driven), scene_after(last, driven, resolution)}};
  };
  return gif_of_frames({.frames = kFrames, .panels_at = panels_at}, style);
}

}  // namespace wend::cli
