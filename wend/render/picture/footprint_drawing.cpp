// The polygon of a robot, to scale: at the ends of a path and along it.

#include <algorithm>
#include <span>
#include <vector>

#include "wend/path/outline_poses.hpp"
#include "wend/path/polyline.hpp"
#include "wend/render/picture/scene_drawing.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"

namespace wend {
namespace {

constexpr double kLeastSize = 6;  // pixels across; smaller outlines are only specks

/// Poses along the last line of the scene, else along the path; none where the robot only stands.
std::vector<Pose> shown_poses(const Scene& scene) {
  const double radius = scene.space.radius_in_cells();
  const bool has_line = !scene.lines.empty() && scene.lines.back().role != LineRole::possible;
  if (!has_line)
    return scene.path.size() < 2 ? std::vector<Pose>{} : outline_poses(scene.path, radius);
  const std::vector<Point>& points = scene.lines.back().points;
  return points.size() < 2 ? std::vector<Pose>{} : outline_poses(Polyline(points), radius);
}

}  // namespace

void trace_footprint(const SceneDrawing& drawing, const Pose& pose) {
  const PlacedPolygon robot(*drawing.scene.space.outline(), pose);
  cairo_new_path(drawing.context);
  for (const Point corner : robot.corners()) {
    const Point point = drawing.view.to_picture(corner);
    cairo_line_to(drawing.context, point.x, point.y);
  }
  cairo_close_path(drawing.context);
}

void draw_footprints(const SceneDrawing& drawing) {
  const Scene& scene = drawing.scene;
  if (2 * scene.space.radius_in_cells() * drawing.view.scale() < kLeastSize) return;
  const std::vector<Pose> poses = shown_poses(scene);
  const double width = std::max(1.0, drawing.sizes.line / 4);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool at_end = i == 0 || i + 1 == poses.size();
    const Colour& colour = i + 1 == poses.size() ? drawing.style.goal : drawing.style.start;
    trace_footprint(drawing, poses[i]);
    if (at_end) fill_and_keep(drawing.context, colour, 0.2);
    stroke(drawing.context, width, at_end ? colour : drawing.style.start, at_end ? 0.9 : 0.7);
  }
}

}  // namespace wend
