// What a search over poses drove, as a tree of thin lines.

#include <algorithm>

#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

constexpr double kWidth = 0.4;             // in widths of the path
constexpr double kLeastMotionWidth = 0.8;  // pixels

}  // namespace

void draw_motions(const SceneDrawing& drawing) {
  const Scene& scene = drawing.scene;
  if (scene.motions.empty()) return;
  const auto given = scene.heatmap ? range_of(*scene.heatmap) : std::nullopt;
  const HeatRange range = given.value_or(HeatRange{1, static_cast<double>(scene.motions.size())});
  const double width = std::max(kLeastMotionWidth, kWidth * drawing.sizes.line);
  cairo_save(drawing.context);
  cairo_set_line_cap(drawing.context, CAIRO_LINE_CAP_ROUND);
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    trace_drive(drawing.context, scene.motions.branch(i), drawing.view);
    stroke(drawing.context, width, drawing.style.heat(range.share(static_cast<double>(i + 1))));
  }
  cairo_restore(drawing.context);
}

}  // namespace wend
