#include "wend/render/picture/arrows.hpp"

#include <algorithm>
#include <cmath>

namespace wend {
namespace {

constexpr double kLeastSpacing = 15;  // pixels from arrow to arrow
constexpr double kLongest = 34;       // pixels
constexpr double kShareOfSpacing = 0.62;
constexpr double kShareIfRaised = 0.42;
constexpr double kRise = 0.16;  // of a cell

/// Adds shaft and head to the path that is to be stroked.
void trace_arrow(cairo_t* context, Point centre, double length, Direction direction) {
  const Cell drawn = kDrawnSteps[static_cast<std::size_t>(direction)];
  const double norm = std::hypot(drawn.x, drawn.y);
  const Point along{drawn.x / norm, drawn.y / norm};
  const Point tip{centre.x + along.x * length / 2, centre.y + along.y * length / 2};
  const double head = 0.36 * length;
  cairo_move_to(context, tip.x - along.x * length, tip.y - along.y * length);
  cairo_line_to(context, tip.x, tip.y);
  for (const double side : {-1.0, 1.0}) {
    cairo_move_to(context, tip.x - head * (along.x + side * 0.8 * along.y),
                  tip.y - head * (along.y - side * 0.8 * along.x));
    cairo_line_to(context, tip.x, tip.y);
  }
}

void stroke(cairo_t* context, double length, const Colour& colour) {
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(context, std::clamp(0.1 * length, 1.2, 3.0));
  set_source(context, colour);
  cairo_stroke(context);
}

}  // namespace

void draw_arrow(cairo_t* context, Point centre, double length, Direction direction,
                const Colour& colour) {
  cairo_new_path(context);
  trace_arrow(context, centre, length, direction);
  stroke(context, length, colour);
}

void draw_arrows(cairo_t* context, const ArrowField& arrows, const MapView& view, bool raised,
                 const Style& style) {
  const int block = std::max(1, static_cast<int>(std::ceil(kLeastSpacing / view.scale())));
  const double share = raised ? kShareIfRaised : kShareOfSpacing;
  const double length = std::min(kLongest, share * block * view.scale());
  const double rise = raised ? kRise * view.scale() : 0;
  cairo_new_path(context);
  for (int y = block / 2; y < arrows.height(); y += block) {
    for (int x = block / 2; x < arrows.width(); x += block) {
      const auto direction = arrows[{x, y}];
      if (!direction) continue;
      const Point centre = view.to_picture(centre_of(Cell{x, y}));
      trace_arrow(context, {centre.x, centre.y - rise}, length, *direction);
    }
  }
  stroke(context, length, style.arrows);
}

}  // namespace wend
