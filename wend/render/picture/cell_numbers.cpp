#include "wend/render/picture/cell_numbers.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "wend/render/number_text.hpp"
#include "wend/render/picture/cell_paints.hpp"
#include "wend/render/picture/labels.hpp"

namespace wend {
namespace {

constexpr double kFrom = 30;            // pixels a cell
constexpr double kShareOfWidth = 0.86;  // of a cell, for the longest number
constexpr double kSmallest = 9;         // font sizes
constexpr double kLargest = 22;

/// The largest size in which that many digits fit across a cell; nothing if it is not readable.
std::optional<double> font_size(cairo_t* context, const NumberText& text, double scale) {
  if (scale < kFrom || text.columns() == 0) return std::nullopt;
  select_label_font(context, kLargest);
  const std::string longest(static_cast<std::size_t>(text.columns()), '8');
  const double fitting = kLargest * kShareOfWidth * scale / text_width(context, longest);
  const double size = std::min({fitting, kLargest, 0.32 * scale});
  if (size < kSmallest) return std::nullopt;
  return size;
}

/// So that the path does not run through digits.
void draw_rim(cairo_t* context, Point baseline, const std::string& number, const Colour& colour) {
  cairo_move_to(context, baseline.x, baseline.y);
  cairo_text_path(context, number.c_str());
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_width(context, 5);
  set_source(context, colour);
  cairo_stroke(context);
}

}  // namespace

bool shows_cell_numbers(cairo_t* context, const Scene& scene, const MapView& view) {
  return scene.heatmap && font_size(context, NumberText(scene.heatmap->values), view.scale());
}

void draw_cell_numbers(cairo_t* context, const Scene& scene, const MapView& view,
                       const Style& style) {
  if (!scene.heatmap) return;
  const Grid<double>& values = scene.heatmap->values;
  const NumberText text(values);
  const auto size = font_size(context, text, view.scale());
  if (!size) return;
  select_label_font(context, *size);
  const CellPaints paints(scene, style);
  const bool aside = !scene.path.cells().empty() || scene.arrows;
  const double below_middle = aside ? 0.44 * view.scale() : 0.35 * *size;
  for (int y = 0; y < values.height(); ++y) {
    for (int x = 0; x < values.width(); ++x) {
      const double value = values[{x, y}];
      if (!paints.heat({x, y})) continue;
      const std::string number = text(value);
      const Colour under = paints[{x, y}].colour;
      const Point centre = view.to_picture(centre_of(Cell{x, y}));
      const Point baseline{centre.x - text_width(context, number) / 2, centre.y + below_middle};
      if (!scene.path.empty()) draw_rim(context, baseline, number, under);
      draw_text(context, baseline, number, readable_on(under));
    }
  }
}

}  // namespace wend
