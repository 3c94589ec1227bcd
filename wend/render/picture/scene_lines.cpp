#include "wend/render/picture/scene_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr double kLeastPointDistance = 0.25;  // pixels; points nearer to each other are one
constexpr double kLeastLineWidth = 1;         // pixels
constexpr double kTick = 1.35;                // how far the robot's tick reaches, in radii

bool is_dashed(LineRole role) { return role == LineRole::planned || role == LineRole::possible; }

/// In widths of a path's line: what is driven leaves the others to be seen.
constexpr double share_of(LineRole role) {
  switch (role) {
    case LineRole::planned:
      return 0.8;
    case LineRole::smoothed:
      return 1.5;
    case LineRole::possible:
      return 1;
    case LineRole::driven:
      break;
  }
  return 0.45;
}

/// Pixels.
double width_of(LineRole role, const MarkSizes& sizes) {
  return std::max(kLeastLineWidth, share_of(role) * sizes.line);
}

void trace(cairo_t* context, const std::vector<Point>& points, const MapView& view) {
  cairo_new_path(context);
  Point last = view.to_picture(points.front());
  cairo_move_to(context, last.x, last.y);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point point = view.to_picture(points[i]);
    if (i + 1 < points.size() && distance(last, point) < kLeastPointDistance) continue;
    cairo_line_to(context, point.x, point.y);
    last = point;
  }
}

/// What has been traced, around which the halo is already drawn.
void stroke(cairo_t* context, LineRole role, const MarkSizes& sizes, const Style& style) {
  const double width = width_of(role, sizes);
  cairo_save(context);
  // In half blocks, dashes would cut up what another line explains; of a possible path they say
  // that it is none.
  if (is_dashed(role) && (sizes.halo > 0 || role == LineRole::possible)) {
    const std::array<double, 2> dashes{2.6 * width, 2.2 * width};
    cairo_set_dash(context, dashes.data(), static_cast<int>(dashes.size()), 0);
  }
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(context, width);
  set_source(context, style.of(role));
  cairo_stroke(context);
  cairo_restore(context);
}

void stroke_halo(cairo_t* context, LineRole role, const MarkSizes& sizes, const Style& style) {
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(context, width_of(role, sizes) + 2 * sizes.halo);
  set_source(context, style.halo);
  cairo_stroke(context);
}

}  // namespace

void draw_lines(cairo_t* context, const Scene& scene, const MapView& view, const MarkSizes& sizes,
                const Style& style) {
  // All halos first: none lies on a line.
  for (const SceneLine& line : scene.lines) {
    if (line.points.empty() || sizes.halo <= 0) continue;
    trace(context, line.points, view);
    stroke_halo(context, line.role, sizes, style);
  }
  for (const SceneLine& line : scene.lines) {
    if (line.points.empty()) continue;
    trace(context, line.points, view);
    stroke(context, line.role, sizes, style);
  }
}

void draw_robot_at(cairo_t* context, const Scene& scene, const MapView& view,
                   const MarkSizes& sizes, const Style& style) {
  if (!scene.robot) return;
  const Point centre = view.to_picture(scene.robot->point());
  const double angle = view.y_up ? -scene.robot->heading : scene.robot->heading;
  const double radius =
      std::max({scene.space.radius_in_cells() * view.scale(), 2.0, 0.7 * sizes.mark});
  const double line = std::max(kLeastLineWidth, 0.5 * sizes.line);
  cairo_save(context);
  cairo_new_path(context);
  cairo_arc(context, centre.x, centre.y, radius, 0, 2 * kPi);
  set_source(context, style.halo, 0.75);
  cairo_set_line_width(context, line + 2 * sizes.halo);
  cairo_stroke_preserve(context);
  set_source(context, style.lines.driven, 0.35);
  cairo_fill_preserve(context);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_move_to(context, centre.x, centre.y);
  cairo_rel_line_to(context, kTick * radius * std::cos(angle), kTick * radius * std::sin(angle));
  set_source(context, style.lines.driven);
  cairo_set_line_width(context, line);
  cairo_stroke(context);
  cairo_restore(context);
}

void draw_line_sample(cairo_t* context, Point centre, double length, LineRole role,
                      const Style& style) {
  constexpr MarkSizes kSizes{.line = 4, .halo = 1.5, .mark = 0};
  for (const bool halo : {true, false}) {
    cairo_new_path(context);
    cairo_move_to(context, centre.x - length / 2, centre.y);
    cairo_rel_line_to(context, length, 0);
    halo ? stroke_halo(context, role, kSizes, style) : stroke(context, role, kSizes, style);
  }
}

}  // namespace wend
