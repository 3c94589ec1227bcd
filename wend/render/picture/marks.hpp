#pragma once

// Marks: what lies on the map in a picture: the path, the start with the robot to scale, the goals,
// a collision. Their size is in pixels, so that they stay visible however small the cells are. A start or a goal
// with a heading has a tip that points there.

#include <optional>

#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

struct MarkSizes {
  double line = 3;    // width of the path
  double halo = 1.5;  // width of the rim around path and marks
  double mark = 8;    // radius of start and goal
};

/// How far the mark of the narrowest place reaches, in radii of the other marks.
inline constexpr double kNarrowestReach = 2.3;

/// Sizes for a picture of that scale: by the cells, or by a car's lattice, whose corners need room.
MarkSizes mark_sizes(const Scene& scene, const MapView& view);

/// Where a mark lies in the picture, and the angle of its tip, clockwise from the right.
struct DrawnPlace {
  Point centre;
  std::optional<double> angle{};
};

void draw_start_mark(cairo_t* context, const DrawnPlace& place, const MarkSizes& sizes,
                     const Style& style);
void draw_goal_mark(cairo_t* context, const DrawnPlace& place, const MarkSizes& sizes,
                    const Style& style);
/// A ring with four ticks.
void draw_narrowest_mark(cairo_t* context, Point centre, const MarkSizes& sizes,
                         const Style& style);

/// A diamond.
void draw_nearest_free_mark(cairo_t* context, Point centre, const MarkSizes& sizes,
                            const Style& style);

/// A cross.
void draw_collision_mark(cairo_t* context, Point centre, const MarkSizes& sizes,
                         const Style& style);

/// The path and the lines, and the robot to scale: where it is, or at the start.
void draw_path(cairo_t* context, const Scene& scene, const MapView& view, const MarkSizes& sizes,
               const Style& style);

/// Start, goals, the narrowest place, the nearest free cells and the collision.
void draw_marks(cairo_t* context, const Scene& scene, const MapView& view, const MarkSizes& sizes,
                const Style& style);

}  // namespace wend
