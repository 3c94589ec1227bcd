#pragma once

// A scene's lines in a picture, exactly through their points: planned and possible ones dashed,
// smoothed ones wide, driven ones thin, so that each is seen where they lie on top of each other.
// And the robot that drives them, to scale.

#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/picture/marks.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

void draw_lines(cairo_t* context, const Scene& scene, const MapView& view, const MarkSizes& sizes,
                const Style& style);

/// The scene's robot: its disc, or a small one where that could not be seen, and a tick that points
/// along its heading.
void draw_robot_at(cairo_t* context, const Scene& scene, const MapView& view,
                   const MarkSizes& sizes, const Style& style);

/// A horizontal piece of a line, for a legend.
void draw_line_sample(cairo_t* context, Point centre, double length, LineRole role,
                      const Style& style);

}  // namespace wend
