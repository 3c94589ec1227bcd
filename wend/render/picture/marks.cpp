#include "wend/render/picture/marks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/render/picture/driven_path.hpp"
#include "wend/render/picture/scene_lines.hpp"

namespace wend {
namespace {

constexpr double kLeastMarkDistance = 1;  // pixels; points of cells nearer to each other are one
constexpr double kLeastBend = 4;          // pixels
constexpr double kLeastRound = 3;         // pixels; marks of a smaller radius are squares
constexpr double kTip = 1.7;              // how far a heading's tip reaches, in radii of its mark

void circle(cairo_t* context, Point centre, double radius) {
  cairo_new_path(context);
  cairo_arc(context, centre.x, centre.y, radius, 0, 2 * kPi);
}

/// Whole pixels around the one that holds the centre.
void fill_square(cairo_t* context, Point centre, double radius, const Colour& colour) {
  const double reach = std::floor(radius);
  cairo_rectangle(context, std::floor(centre.x) - reach, std::floor(centre.y) - reach,
                  2 * reach + 1, 2 * reach + 1);
  set_source(context, colour);
  cairo_fill(context);
}

/// A frame one pixel wide, so far from the pixel that holds the centre that this one is seen.
void frame_square(cairo_t* context, Point centre, double radius, const Colour& colour) {
  const double reach = std::floor(radius) + 1;
  cairo_rectangle(context, std::floor(centre.x) - reach + 0.5, std::floor(centre.y) - reach + 0.5,
                  2 * reach, 2 * reach);
  set_source(context, colour);
  cairo_set_line_width(context, 1);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_MITER);
  cairo_stroke(context);
}

bool goes_straight_on(Point a, Point b, Point c) {
  const double cross = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
  const double dot = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
  return std::abs(cross) < 1e-6 && dot > 0;
}

/// The path's bends in picture coordinates.
std::vector<Point> bends_of(const Path& path, const MapView& view) {
  std::vector<Point> bends;
  const std::vector<Point> points = path.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point point = view.to_picture(points[i]);
    const bool last = i + 1 == points.size();
    if (!last && !bends.empty() && distance(point, bends.back()) < kLeastMarkDistance) continue;
    const std::size_t count = bends.size();
    if (count >= 2 && goes_straight_on(bends[count - 2], bends[count - 1], point)) bends.pop_back();
    bends.push_back(point);
  }
  return bends;
}

Point towards(Point from, Point to, double length) {
  const double share = length / distance(from, to);
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

/// A quarter-circle-like bend that leaves the polyline at most `radius` before and after a point.
void bend(cairo_t* context, Point before, Point point, Point after, double radius) {
  const Point in = towards(point, before, std::min(radius, distance(point, before) / 2));
  const Point out = towards(point, after, std::min(radius, distance(point, after) / 2));
  cairo_line_to(context, in.x, in.y);
  cairo_curve_to(context, (in.x + 2 * point.x) / 3, (in.y + 2 * point.y) / 3,
                 (out.x + 2 * point.x) / 3, (out.y + 2 * point.y) / 3, out.x, out.y);
}

/// With rounded bends, if there is room for them.
void trace(cairo_t* context, const std::vector<Point>& bends, double scale) {
  cairo_new_path(context);
  cairo_move_to(context, bends.front().x, bends.front().y);
  for (std::size_t i = 1; i + 1 < bends.size(); ++i) {
    if (scale >= 1) {
      bend(context, bends[i - 1], bends[i], bends[i + 1], std::max(kLeastBend, scale / 2));
    } else {
      cairo_line_to(context, bends[i].x, bends[i].y);
    }
  }
  cairo_line_to(context, bends.back().x, bends.back().y);
}

void draw_line(cairo_t* context, const Path& path, const MapView& view, const MarkSizes& sizes,
               const Style& style) {
  const std::vector<Point> bends = bends_of(path, view);
  if (bends.size() < 2) return;
  // Waypoints are where they are; bends between cells may be rounded.
  trace(context, bends, path.waypoints().empty() ? view.scale() : 0);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  if (sizes.halo > 0) {
    set_source(context, style.halo);
    cairo_set_line_width(context, sizes.line + 2 * sizes.halo);
    cairo_stroke_preserve(context);
  }
  set_source(context, style.path);
  cairo_set_line_width(context, sizes.line);
  cairo_stroke(context);
}

/// The robot to scale, where it is larger than the mark at its centre.
void draw_robot(cairo_t* context, Point centre, double radius, const MarkSizes& sizes,
                const Style& style) {
  if (radius < 1.2 * (sizes.mark + sizes.halo)) return;
  circle(context, centre, radius);
  set_source(context, style.start, 0.2);
  cairo_fill_preserve(context);
  set_source(context, style.start, 0.8);
  cairo_set_line_width(context, sizes.line / 2);
  cairo_stroke(context);
}

/// A disc; with a heading, one that runs out into a tip.
void trace_mark(cairo_t* context, const DrawnPlace& place, double radius) {
  if (!place.angle) return circle(context, place.centre, radius);
  const double side = std::acos(1 / kTip);  // where the tip's sides leave the disc
  const Point& centre = place.centre;
  cairo_new_path(context);
  cairo_arc(context, centre.x, centre.y, radius, *place.angle + side, *place.angle - side);
  cairo_line_to(context, centre.x + kTip * radius * std::cos(*place.angle),
                centre.y + kTip * radius * std::sin(*place.angle));
  cairo_close_path(context);
}

void draw_rim(cairo_t* context, const DrawnPlace& place, const MarkSizes& sizes,
              const Style& style) {
  trace_mark(context, place, sizes.mark);
  set_source(context, style.halo);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_width(context, 2 * sizes.halo);
  cairo_stroke_preserve(context);
  cairo_fill(context);
}

DrawnPlace drawn(const ScenePlace& place, const MapView& view) {
  DrawnPlace drawn{view.to_picture(place.point)};
  if (place.heading) drawn.angle = view.y_up ? -*place.heading : *place.heading;
  return drawn;
}

bool on_map(const Scene& scene, Point point) {
  return point.x >= 0 && point.y >= 0 && point.x <= scene.space.width() &&
         point.y <= scene.space.height();
}

}  // namespace

MarkSizes mark_sizes(const Scene& scene, const MapView& view) {
  const double scale = scene.unit.value_or(1) * view.scale();
  const double line = std::clamp(0.2 * scale, 3.5, 9.0);
  MarkSizes sizes{.line = line,
                  .halo = std::clamp(0.35 * line, 1.25, 3.0),
                  .mark = std::clamp(0.3 * scale, 9.0, 18.0)};
  if (scene.unit || scene.path.driven()) {
    sizes.line = std::max(3.0, 0.62 * sizes.line);
    sizes.mark *= 0.75;
  }
  return sizes;
}

void draw_start_mark(cairo_t* context, const DrawnPlace& place, const MarkSizes& sizes,
                     const Style& style) {
  if (sizes.mark < kLeastRound) return fill_square(context, place.centre, sizes.mark, style.start);
  draw_rim(context, place, sizes, style);
  trace_mark(context, place, sizes.mark);
  set_source(context, style.start);
  cairo_fill(context);
}

void draw_goal_mark(cairo_t* context, const DrawnPlace& place, const MarkSizes& sizes,
                    const Style& style) {
  if (sizes.mark < kLeastRound) return fill_square(context, place.centre, sizes.mark, style.goal);
  draw_rim(context, place, sizes, style);
  trace_mark(context, place, sizes.mark);
  set_source(context, style.goal);
  cairo_fill(context);
  circle(context, place.centre, 0.65 * sizes.mark);
  set_source(context, style.halo);
  cairo_fill(context);
  circle(context, place.centre, 0.35 * sizes.mark);
  set_source(context, style.goal);
  cairo_fill(context);
}

void draw_narrowest_mark(cairo_t* context, Point centre, const MarkSizes& sizes,
                         const Style& style) {
  if (sizes.mark < kLeastRound) return frame_square(context, centre, sizes.mark, style.narrowest);
  const double line = 0.4 * sizes.mark;
  const double radius = 1.3 * sizes.mark;
  const double tick = kNarrowestReach * sizes.mark - radius - line / 2;
  circle(context, centre, radius);
  for (int i = 0; i < 4; ++i) {
    const double across = i == 0 ? 1 : i == 2 ? -1 : 0;
    const double down = i == 1 ? 1 : i == 3 ? -1 : 0;
    cairo_move_to(context, centre.x + radius * across, centre.y + radius * down);
    cairo_rel_line_to(context, tick * across, tick * down);
  }
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  set_source(context, style.halo);
  cairo_set_line_width(context, line + 2 * sizes.halo);
  cairo_stroke_preserve(context);
  set_source(context, style.narrowest);
  cairo_set_line_width(context, line);
  cairo_stroke(context);
}

void draw_nearest_free_mark(cairo_t* context, Point centre, const MarkSizes& sizes,
                            const Style& style) {
  if (sizes.mark < kLeastRound) {
    return fill_square(context, centre, sizes.mark, style.narrowest);
  }
  const double reach = sizes.mark;
  cairo_new_path(context);
  cairo_move_to(context, centre.x, centre.y - reach);
  cairo_rel_line_to(context, reach, reach);
  cairo_rel_line_to(context, -reach, reach);
  cairo_rel_line_to(context, -reach, -reach);
  cairo_close_path(context);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_MITER);
  set_source(context, style.halo);
  cairo_set_line_width(context, 2 * sizes.halo);
  cairo_stroke_preserve(context);
  set_source(context, style.narrowest);
  cairo_fill(context);
}

void draw_collision_mark(cairo_t* context, Point centre, const MarkSizes& sizes,
                         const Style& style) {
  if (sizes.mark < kLeastRound) {
    return fill_square(context, centre, sizes.mark, style.narrowest);
  }
  const double reach = 0.75 * sizes.mark;
  const double line = 0.4 * sizes.mark;
  cairo_new_path(context);
  for (const double side : {-1.0, 1.0}) {
    cairo_move_to(context, centre.x - reach, centre.y - side * reach);
    cairo_rel_line_to(context, 2 * reach, side * 2 * reach);
  }
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  set_source(context, style.halo);
  cairo_set_line_width(context, line + 2 * sizes.halo);
  cairo_stroke_preserve(context);
  set_source(context, style.narrowest);
  cairo_set_line_width(context, line);
  cairo_stroke(context);
}

void draw_path(cairo_t* context, const Scene& scene, const MapView& view, const MarkSizes& sizes,
               const Style& style) {
  // A car may drive along the edge of the map.
  const double beyond = scene.path.driven() ? sizes.line : 0;
  cairo_save(context);
  cairo_rectangle(context, view.left - beyond, view.top - beyond, view.width + 2 * beyond,
                  view.height + 2 * beyond);
  cairo_clip(context);
  if (scene.start && !scene.robot && on_map(scene, scene.start->point)) {
    draw_robot(context, view.to_picture(scene.start->point),
               scene.space.radius_in_cells() * view.scale(), sizes, style);
  }
  if (scene.path.driven()) {
    draw_driven_path(context, scene, view, sizes, style);
  } else if (!scene.path.empty()) {
    draw_line(context, scene.path, view, sizes, style);
  }
  draw_lines(context, scene, view, sizes, style);
  draw_robot_at(context, scene, view, sizes, style);
  cairo_restore(context);
}

void draw_marks(cairo_t* context, const Scene& scene, const MapView& view, const MarkSizes& sizes,
                const Style& style) {
  for (const ScenePlace& goal : scene.goals) {
    if (on_map(scene, goal.point)) draw_goal_mark(context, drawn(goal, view), sizes, style);
  }
  if (scene.start && on_map(scene, scene.start->point)) {
    draw_start_mark(context, drawn(*scene.start, view), sizes, style);
  }
  if (scene.narrowest && on_map(scene, *scene.narrowest)) {
    draw_narrowest_mark(context, view.to_picture(*scene.narrowest), sizes, style);
  }
  for (const Cell cell : scene.nearest_free) {
    if (!on_map(scene, centre_of(cell))) continue;
    draw_nearest_free_mark(context, view.to_picture(centre_of(cell)), sizes, style);
  }
  if (scene.collision && on_map(scene, *scene.collision)) {
    draw_collision_mark(context, view.to_picture(*scene.collision), sizes, style);
  }
}

}  // namespace wend
