// The path, lines, and the robot to scale.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "wend/geometry/angle.hpp"
#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

constexpr double kLeastMarkDistance = 1;  // pixels; points of cells nearer to each other are one
constexpr double kLeastPointDistance =
    0.25;                              // pixels; points of lines nearer to each other are one
constexpr double kLeastBend = 4;       // pixels
constexpr double kLeastDash = 1.5;     // pixels; dashes are as long as those of a line so wide
constexpr double kLeastLineWidth = 1;  // pixels
constexpr double kArrow = 3.6;         // an arrow's length, in widths of the line
constexpr double kArrowSpacing = 1.7;  // from arrow to arrow at least, in lengths of an arrow
constexpr double kTick = 1.35;         // how far the robot's tick reaches, in radii

void set_round_line(cairo_t* context) {
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
}

/// Dashes and gaps, in widths of the line.
void set_dashes(cairo_t* context, double width, double dash, double gap) {
  const std::array<double, 2> dashes{dash * width, gap * width};
  cairo_set_dash(context, dashes.data(), static_cast<int>(dashes.size()), 0);
}

void trace_sample(cairo_t* context, Point centre, double length) {
  cairo_new_path(context);
  cairo_move_to(context, centre.x - length / 2, centre.y);
  cairo_rel_line_to(context, length, 0);
}

// Paths of cells and waypoints.

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
void trace_bend(cairo_t* context, Point before, Point point, Point after, double radius) {
  const Point in = towards(point, before, std::min(radius, distance(point, before) / 2));
  const Point out = towards(point, after, std::min(radius, distance(point, after) / 2));
  cairo_line_to(context, in.x, in.y);
  cairo_curve_to(context, (in.x + 2 * point.x) / 3, (in.y + 2 * point.y) / 3,
                 (out.x + 2 * point.x) / 3, (out.y + 2 * point.y) / 3, out.x, out.y);
}

/// Rounded, if there is room for that.
void draw_bent_path(const SceneDrawing& drawing, bool rounded) {
  cairo_t* const context = drawing.context;
  const std::vector<Point> bends = bends_of(drawing.scene.path, drawing.view);
  if (bends.size() < 2) return;
  const double scale = drawing.view.scale();
  cairo_new_path(context);
  cairo_move_to(context, bends.front().x, bends.front().y);
  for (std::size_t i = 1; i + 1 < bends.size(); ++i) {
    if (rounded && scale >= 1) {
      trace_bend(context, bends[i - 1], bends[i], bends[i + 1], std::max(kLeastBend, scale / 2));
    } else {
      cairo_line_to(context, bends[i].x, bends[i].y);
    }
  }
  cairo_line_to(context, bends.back().x, bends.back().y);
  set_round_line(context);
  stroke_with_halo(drawing, drawing.sizes.line, drawing.style.path);
}

// Car paths.

bool in_reverse(const Arc& arc) { return arc.length < 0; }

/// Grid coordinates, until the context is restored.
void enter_grid(cairo_t* context, const MapView& view) {
  const double across = static_cast<double>(view.width) / view.columns;
  const double down = static_cast<double>(view.height) / view.rows;
  cairo_translate(context, view.left, view.y_up ? view.bottom() : view.top);
  cairo_scale(context, across, view.y_up ? -down : down);
}

/// From where the arc begins.
void trace_arc(cairo_t* context, const Arc& arc) {
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
void trace_gear(cairo_t* context, const std::vector<Arc>& arcs, const MapView& view, bool reverse) {
  cairo_save(context);
  enter_grid(context, view);
  cairo_new_path(context);
  bool joined = false;
  for (const Arc& arc : arcs) {
    const bool wanted = in_reverse(arc) == reverse;
    if (wanted && !joined) cairo_move_to(context, arc.from.x, arc.from.y);
    if (wanted) trace_arc(context, arc);
    joined = wanted;
  }
  cairo_restore(context);  // the path stays, and is stroked in pixels
}

/// What is traced, with its halo.
void stroke_gear(const Pen& pen, bool reverse) {
  const auto& [context, sizes, style] = pen;
  cairo_save(context);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  if (sizes.halo > 0) {
    stroke_and_keep(context, sizes.line + 2 * sizes.halo, style.halo);
    if (reverse) set_dashes(context, sizes.line, 1.9, 1.3);
  } else {
    // Pixels of a line between two cells would all be half of something else.
    cairo_set_antialias(context, CAIRO_ANTIALIAS_NONE);
  }
  stroke(context, sizes.line, reverse ? style.reverse : style.path);
  cairo_restore(context);
}

/// The angle is clockwise from the right.
void draw_pose_arrow(const Pen& pen, Point point, double angle, bool reverse) {
  cairo_t* const context = pen.context;
  const double length = kArrow * pen.sizes.line;
  cairo_save(context);
  cairo_translate(context, point.x, point.y);
  cairo_rotate(context, angle);
  cairo_scale(context, length, length);
  cairo_new_path(context);
  cairo_move_to(context, 0.58, 0);
  cairo_line_to(context, -0.42, 0.42);
  cairo_line_to(context, -0.2, 0);
  cairo_line_to(context, -0.42, -0.42);
  cairo_close_path(context);
  cairo_restore(context);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  fill_with_halo(pen, reverse ? pen.style.reverse : pen.style.path);
}

/// At all poses that are far enough from the arrow before.
void draw_pose_arrows(const SceneDrawing& drawing, const std::vector<Arc>& arcs) {
  const MapView& view = drawing.view;
  const std::vector<Pose> poses = drawing.scene.path.poses();
  const double spacing = kArrowSpacing * kArrow * drawing.sizes.line;
  double since = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i > 0) since += std::abs(arcs[i - 1].length) * view.scale();
    if (since < spacing) continue;
    since = 0;
    const bool reverse = !arcs.empty() && in_reverse(arcs[i > 0 ? i - 1 : 0]);
    draw_pose_arrow(drawing, view.to_picture(poses[i].point()), view.angle_of(poses[i].heading),
                    reverse);
  }
}

void draw_driven_path(const SceneDrawing& drawing) {
  const std::vector<Arc> arcs = drawing.scene.path.arcs();
  // Where the car drives back the way it came, the dashes lie on top.
  for (const bool reverse : {false, true}) {
    trace_gear(drawing.context, arcs, drawing.view, reverse);
    stroke_gear(drawing, reverse);
  }
  // Where a pixel is as large as half a character, colours alone tell the two gears apart.
  if (drawing.sizes.halo > 0) draw_pose_arrows(drawing, arcs);
}

// Lines.

/// In pixels, by widths of a path's line: what is driven leaves the others to be seen.
double width_of(LineRole role, const MarkSizes& sizes) {
  static constexpr std::array<double, kLineRoles> kShares{0.8, 1.5, 0.45, 1};
  return std::max(kLeastLineWidth, kShares[static_cast<std::size_t>(role)] * sizes.line);
}

void trace_points(cairo_t* context, const std::vector<Point>& points, const MapView& view) {
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

/// What is traced, around which the halo is already drawn.
void stroke_line(const Pen& pen, LineRole role) {
  const double width = width_of(role, pen.sizes);
  cairo_save(pen.context);
  // In half blocks, dashes would cut up what another line explains; of a possible path they say
  // that it does not exist yet.
  const bool dashed =
      role == LineRole::possible || (role == LineRole::planned && pen.sizes.halo > 0);
  const double drawn = dashed ? std::max(width, kLeastDash) : width;
  // Half characters are not smooth elsewhere, but gaps of a thin line would vanish.
  if (dashed) cairo_set_antialias(pen.context, CAIRO_ANTIALIAS_DEFAULT);
  if (dashed) set_dashes(pen.context, drawn, 2.6, 2.2);
  set_round_line(pen.context);
  stroke(pen.context, drawn, pen.style.of(role));
  cairo_restore(pen.context);
}

void stroke_line_halo(const Pen& pen, LineRole role) {
  set_round_line(pen.context);
  stroke(pen.context, width_of(role, pen.sizes) + 2 * pen.sizes.halo, pen.style.halo);
}

void draw_lines(const SceneDrawing& drawing) {
  // All halos first: none lies on a line.
  for (const bool halo : {true, false}) {
    if (halo && drawing.sizes.halo <= 0) continue;
    for (const SceneLine& line : drawing.scene.lines) {
      if (line.points.empty()) continue;
      trace_points(drawing.context, line.points, drawing.view);
      halo ? stroke_line_halo(drawing, line.role) : stroke_line(drawing, line.role);
    }
  }
}

// The robot.

/// At the start, where it is larger than the mark at its centre.
void draw_robot_at_start(const SceneDrawing& drawing) {
  const auto& [line, halo, mark] = drawing.sizes;
  const auto& start = drawing.scene.start;
  const double radius = drawing.scene.space.radius_in_cells() * drawing.view.scale();
  if (halo <= 0) return;  // it would hide what is around the start
  if (!start || radius < 1.2 * (mark + halo)) return;
  trace_circle(drawing.context, drawing.view.to_picture(start->point), radius);
  fill_and_keep(drawing.context, drawing.style.start, 0.2);
  stroke(drawing.context, line / 2, drawing.style.start, 0.8);
}

/// Where it is: its shape, or a small disc where that could not be seen, and a tick that points along
/// its heading.
void draw_robot(const SceneDrawing& drawing) {
  cairo_t* const context = drawing.context;
  assert(drawing.scene.robot);
  const Pose& robot = *drawing.scene.robot;
  const Point centre = drawing.view.to_picture(robot.point());
  const double angle = drawing.view.angle_of(robot.heading);
  const double scale_radius = drawing.scene.space.radius_in_cells() * drawing.view.scale();
  const bool blocks = drawing.sizes.halo <= 0;
  const double least = blocks ? drawing.sizes.mark : std::max(2.0, 0.7 * drawing.sizes.mark);
  const double radius = std::max(scale_radius, least);
  const double line = std::max(kLeastLineWidth, 0.5 * drawing.sizes.line);
  const Colour& colour = drawing.style.lines.driven;
  cairo_save(context);
  const bool to_scale = radius == scale_radius;
  drawing.scene.space.outline() && to_scale ? trace_footprint(drawing, robot)
                                            : trace_circle(context, centre, radius);
  stroke_and_keep(context, line + 2 * drawing.sizes.halo, drawing.style.halo, 0.75);
  fill_and_keep(context, colour, 0.35);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_move_to(context, centre.x, centre.y);
  cairo_rel_line_to(context, kTick * radius * std::cos(angle), kTick * radius * std::sin(angle));
  stroke(context, line, colour);
  cairo_restore(context);
}

}  // namespace

void draw_path(const SceneDrawing& drawing) {
  const Scene& scene = drawing.scene;
  const MapView& view = drawing.view;
  // A car may drive along the edge of the map.
  const double beyond = scene.path.visit([&](const JoinedPoses&) { return drawing.sizes.line; },
                                         [](const auto&) { return 0.0; });
  cairo_save(drawing.context);
  cairo_rectangle(drawing.context, view.left - beyond, view.top - beyond, view.width + 2 * beyond,
                  view.height + 2 * beyond);
  cairo_clip(drawing.context);
  if (scene.space.outline() && !scene.robot) {
    draw_footprints(drawing);
  } else if (scene.start && !scene.robot && on_map(scene, scene.start->point)) {
    draw_robot_at_start(drawing);
  }
  scene.path.visit([&](const JoinedPoses&) { draw_driven_path(drawing); },
                   [&](std::span<const Cell>) { draw_bent_path(drawing, true); },
                   [&](std::span<const Point>) { draw_bent_path(drawing, false); });
  draw_lines(drawing);
  if (scene.robot) draw_robot(drawing);
  cairo_restore(drawing.context);
}

void trace_drive(cairo_t* context, std::span<const Pose> poses, const MapView& view) {
  const JoinedPoses joined(poses);
  cairo_save(context);
  enter_grid(context, view);
  cairo_new_path(context);
  if (!poses.empty()) cairo_move_to(context, poses.front().x, poses.front().y);
  for (std::size_t i = 0; i < joined.segment_count(); ++i) trace_arc(context, joined.arc(i));
  cairo_restore(context);  // the path stays, and is stroked in pixels
}

void draw_driven_sample(const Pen& pen, Point centre, double length, bool reverse) {
  trace_sample(pen.context, centre, length);
  stroke_gear(pen, reverse);
  if (!reverse) draw_pose_arrow(pen, centre, 0, false);
}

void draw_line_sample(const Pen& pen, Point centre, double length, LineRole role) {
  trace_sample(pen.context, centre, length);
  stroke_line_halo(pen, role);
  trace_sample(pen.context, centre, length);
  stroke_line(pen, role);
}

}  // namespace wend
