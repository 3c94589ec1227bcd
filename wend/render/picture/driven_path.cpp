#include "wend/render/picture/driven_path.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr double kArrow = 3.6;         // an arrow's length, in widths of the line
constexpr double kArrowSpacing = 1.7;  // from arrow to arrow at least, in lengths of an arrow

bool in_reverse(const Arc& arc) { return arc.length < 0; }

/// Where a pose's arrow lies in the picture; the angle is clockwise from the right.
struct DrawnPose {
  Point point;
  double angle = 0;
  bool reverse = false;
};

DrawnPose drawn(const Pose& pose, const MapView& view, bool reverse) {
  return {view.to_picture(pose.point()), view.y_up ? -pose.heading : pose.heading, reverse};
}

/// Grid coordinates, until the context is restored.
void enter_grid(cairo_t* context, const MapView& view) {
  const double across = static_cast<double>(view.width) / view.columns;
  const double down = static_cast<double>(view.height) / view.rows;
  cairo_translate(context, view.left, view.y_up ? view.top + view.height : view.top);
  cairo_scale(context, across, view.y_up ? -down : down);
}

/// From where the arc begins.
void add_arc(cairo_t* context, const Arc& arc) {
  if (arc.curvature == 0) {
    const Pose end = end_of(arc);
    return cairo_line_to(context, end.x, end.y);
  }
  const double radius = 1 / arc.curvature;  // negative where the centre lies on the other side
  const Point centre{arc.from.x - radius * std::sin(arc.from.heading),
                     arc.from.y + radius * std::cos(arc.from.heading)};
  const double begin = arc.from.heading - std::copysign(kPi / 2, radius);
  const auto turn = arc.turn() > 0 ? cairo_arc : cairo_arc_negative;
  turn(context, centre.x, centre.y, std::abs(radius), begin, begin + arc.turn());
}

/// The arcs in one gear, neighbours joined.
void trace(cairo_t* context, const std::vector<Arc>& arcs, const MapView& view, bool reverse) {
  cairo_save(context);
  enter_grid(context, view);
  cairo_new_path(context);
  bool joined = false;
  for (const Arc& arc : arcs) {
    if (in_reverse(arc) != reverse) {
      joined = false;
      continue;
    }
    if (!joined) cairo_move_to(context, arc.from.x, arc.from.y);
    add_arc(context, arc);
    joined = true;
  }
  cairo_restore(context);  // the path stays, and is stroked in pixels
}

/// What is traced, with its halo.
void stroke(cairo_t* context, const MarkSizes& sizes, bool reverse, const Style& style) {
  cairo_save(context);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  // Pixels of a line between two cells would all be half of something else.
  if (sizes.halo <= 0) cairo_set_antialias(context, CAIRO_ANTIALIAS_NONE);
  if (sizes.halo > 0) {
    set_source(context, style.halo);
    cairo_set_line_width(context, sizes.line + 2 * sizes.halo);
    cairo_stroke_preserve(context);
  }
  set_source(context, reverse ? style.reverse : style.path);
  cairo_set_line_width(context, sizes.line);
  if (reverse && sizes.halo > 0) {
    const std::array<double, 2> dashes{1.9 * sizes.line, 1.3 * sizes.line};
    cairo_set_dash(context, dashes.data(), static_cast<int>(dashes.size()), 0);
  }
  cairo_stroke(context);
  cairo_restore(context);
}

/// Where the arrows lie: those of all poses that are far enough from the arrow before.
std::vector<DrawnPose> arrows_of(const std::vector<Pose>& poses, const std::vector<Arc>& arcs,
                                 const MapView& view, double spacing) {
  std::vector<DrawnPose> arrows;
  double since = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i > 0) since += std::abs(arcs[i - 1].length) * view.scale();
    if (since < spacing) continue;
    const bool reverse = !arcs.empty() && in_reverse(arcs[i > 0 ? i - 1 : 0]);
    arrows.push_back(drawn(poses[i], view, reverse));
    since = 0;
  }
  return arrows;
}

void trace_arrow(cairo_t* context, const DrawnPose& pose, double length) {
  cairo_save(context);
  cairo_translate(context, pose.point.x, pose.point.y);
  cairo_rotate(context, pose.angle);
  cairo_scale(context, length, length);
  cairo_new_path(context);
  cairo_move_to(context, 0.58, 0);
  cairo_line_to(context, -0.42, 0.42);
  cairo_line_to(context, -0.2, 0);
  cairo_line_to(context, -0.42, -0.42);
  cairo_close_path(context);
  cairo_restore(context);
}

void draw_pose(cairo_t* context, const DrawnPose& pose, const MarkSizes& sizes,
               const Style& style) {
  trace_arrow(context, pose, kArrow * sizes.line);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_width(context, 2 * sizes.halo);
  set_source(context, style.halo);
  cairo_stroke_preserve(context);
  set_source(context, pose.reverse ? style.reverse : style.path);
  cairo_fill(context);
}

}  // namespace

void draw_driven_path(cairo_t* context, const Scene& scene, const MapView& view,
                      const MarkSizes& sizes, const Style& style) {
  const std::vector<Arc> arcs = scene.path.arcs();
  // Where the car drives back the way it came, the dashes lie on top.
  for (const bool reverse : {false, true}) {
    trace(context, arcs, view, reverse);
    stroke(context, sizes, reverse, style);
  }
  if (sizes.halo <= 0) return;
  const double spacing = kArrowSpacing * kArrow * sizes.line;
  for (const DrawnPose& pose : arrows_of(scene.path.poses(), arcs, view, spacing)) {
    draw_pose(context, pose, sizes, style);
  }
}

void draw_driven_sample(cairo_t* context, Point centre, double length, bool reverse,
                        const Style& style) {
  constexpr MarkSizes kSizes{.line = 4, .halo = 1.5, .mark = 0};
  cairo_new_path(context);
  cairo_move_to(context, centre.x - length / 2, centre.y);
  cairo_rel_line_to(context, length, 0);
  stroke(context, kSizes, reverse, style);
  if (!reverse) draw_pose(context, {centre, 0, false}, kSizes, style);
}

}  // namespace wend
