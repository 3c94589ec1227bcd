// Start, goals, and what a scene points out.

#include <algorithm>
#include <cmath>

#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

constexpr double kTip = 1.7;  // how far a heading's tip reaches, in radii of its mark

/// Whole pixels, so that none beside them changes its colour.
void fill_square(cairo_t* context, Point centre, double side, const Colour& colour) {
  cairo_rectangle(context, std::round(centre.x - side / 2), std::round(centre.y - side / 2), side,
                  side);
  fill(context, colour);
}

/// A disc; with a heading, one that runs out into a tip.
void trace_disc(cairo_t* context, Point centre, double radius, std::optional<double> angle) {
  if (!angle) return trace_circle(context, centre, radius);
  const double side = std::acos(1 / kTip);  // where the tip's sides leave the disc
  cairo_new_path(context);
  cairo_arc(context, centre.x, centre.y, radius, *angle + side, *angle - side);
  cairo_line_to(context, centre.x + kTip * radius * std::cos(*angle),
                centre.y + kTip * radius * std::sin(*angle));
  cairo_close_path(context);
}

void draw_disc(const Pen& pen, Point centre, const Colour& colour, std::optional<double> angle) {
  trace_disc(pen.context, centre, pen.sizes.mark, angle);
  cairo_set_line_join(pen.context, CAIRO_LINE_JOIN_ROUND);
  fill_with_halo(pen, pen.style.halo);
  trace_disc(pen.context, centre, pen.sizes.mark, angle);
  fill(pen.context, colour);
}

void draw_target(const Pen& pen, Point centre, const Colour& colour, std::optional<double> angle) {
  draw_disc(pen, centre, colour, angle);
  trace_circle(pen.context, centre, 0.65 * pen.sizes.mark);
  fill(pen.context, pen.style.halo);
  trace_circle(pen.context, centre, 0.35 * pen.sizes.mark);
  fill(pen.context, colour);
}

void draw_ring_with_ticks(const Pen& pen, Point centre, const Colour& colour) {
  const double line = 0.4 * pen.sizes.mark;
  const double radius = 1.3 * pen.sizes.mark;
  const double tick = kNarrowestReach * pen.sizes.mark - radius - line / 2;
  trace_circle(pen.context, centre, radius);
  for (const Point way : std::array<Point, 4>{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}}) {
    cairo_move_to(pen.context, centre.x + radius * way.x, centre.y + radius * way.y);
    cairo_rel_line_to(pen.context, tick * way.x, tick * way.y);
  }
  cairo_set_line_cap(pen.context, CAIRO_LINE_CAP_ROUND);
  stroke_with_halo(pen, line, colour);
}

void draw_diamond(const Pen& pen, Point centre, const Colour& colour) {
  const double reach = pen.sizes.mark;
  cairo_new_path(pen.context);
  cairo_move_to(pen.context, centre.x, centre.y - reach);
  cairo_rel_line_to(pen.context, reach, reach);
  cairo_rel_line_to(pen.context, -reach, reach);
  cairo_rel_line_to(pen.context, -reach, -reach);
  cairo_close_path(pen.context);
  cairo_set_line_join(pen.context, CAIRO_LINE_JOIN_MITER);
  fill_with_halo(pen, colour);
}

void draw_cross(const Pen& pen, Point centre, const Colour& colour) {
  const double reach = 0.75 * pen.sizes.mark;
  cairo_new_path(pen.context);
  for (const double side : {-1.0, 1.0}) {
    cairo_move_to(pen.context, centre.x - reach, centre.y - side * reach);
    cairo_rel_line_to(pen.context, 2 * reach, side * 2 * reach);
  }
  cairo_set_line_cap(pen.context, CAIRO_LINE_CAP_ROUND);
  stroke_with_halo(pen, 0.4 * pen.sizes.mark, colour);
}

}  // namespace

MarkSizes mark_sizes(const Scene& scene, const MapView& view) {
  const double scale = scene.places.spacing * view.scale();
  const double line = std::clamp(0.2 * scale, 3.5, 9.0);
  MarkSizes sizes{.line = line,
                  .halo = std::clamp(0.35 * line, 1.25, 3.0),
                  .mark = std::clamp(0.3 * scale, 9.0, 18.0)};
  if (scene.places.on_corners() || scene.path.driven()) {
    sizes.line = std::max(3.0, 0.62 * sizes.line);
    sizes.mark *= 0.75;
  }
  return sizes;
}

MarkSizes block_mark_sizes(const MapView& view) {
  constexpr double kWithRim = 3;  // pixels a cell; from here on its own colour shows around a mark
  const double cell = std::max(1.0, std::floor(view.scale()));
  const double side = cell < kWithRim ? cell : cell - 2;
  return {.line = std::max(1.0, std::round(0.4 * cell)), .halo = 0, .mark = side / 2};
}

void stroke_with_halo(const Pen& pen, double width, const Colour& colour) {
  if (pen.sizes.halo > 0) {
    stroke_and_keep(pen.context, width + 2 * pen.sizes.halo, pen.style.halo);
  }
  stroke(pen.context, width, colour);
}

void fill_with_halo(const Pen& pen, const Colour& colour) {
  stroke_and_keep(pen.context, 2 * pen.sizes.halo, pen.style.halo);
  fill(pen.context, colour);
}

void draw_mark(const Pen& pen, Swatch mark, Point centre, std::optional<double> angle) {
  const Style& style = pen.style;
  const Colour& colour = mark == Swatch::start  ? style.start
                         : mark == Swatch::goal ? style.goal
                                                : style.narrowest;
  if (pen.sizes.halo <= 0) return fill_square(pen.context, centre, 2 * pen.sizes.mark, colour);
  if (mark == Swatch::start) draw_disc(pen, centre, colour, angle);
  if (mark == Swatch::goal) draw_target(pen, centre, colour, angle);
  if (mark == Swatch::narrowest) draw_ring_with_ticks(pen, centre, colour);
  if (mark == Swatch::nearest_free) draw_diamond(pen, centre, colour);
  if (mark == Swatch::collision) draw_cross(pen, centre, colour);
}

void draw_marks(const SceneDrawing& drawing) {
  const Scene& scene = drawing.scene;
  const auto draw = [&](Swatch mark, const ScenePlace& place) {
    if (!on_map(scene, place.point)) return;
    std::optional<double> angle;
    if (place.heading) angle = drawing.view.angle_of(*place.heading);
    draw_mark(drawing, mark, drawing.view.to_picture(place.point), angle);
  };
  for (const ScenePlace& goal : scene.goals) draw(Swatch::goal, goal);
  if (scene.start) draw(Swatch::start, *scene.start);
  if (scene.narrowest) draw(Swatch::narrowest, *scene.narrowest);
  for (const Cell cell : scene.nearest_free) draw(Swatch::nearest_free, centre_of(cell));
  if (scene.collision) draw(Swatch::collision, *scene.collision);
}

}  // namespace wend
