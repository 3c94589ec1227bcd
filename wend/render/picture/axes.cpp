#include "wend/render/picture/axes.hpp"

#include <cmath>
#include <string>

#include "wend/render/picture/axis_room.hpp"
#include "wend/render/picture/labels.hpp"

namespace wend {
namespace {

void draw_tick(cairo_t* context, Point from, Point to, const Colour& ink) {
  cairo_new_path(context);
  cairo_move_to(context, from.x, from.y);
  cairo_line_to(context, to.x, to.y);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  cairo_set_line_width(context, 1);
  set_source(context, ink, 0.6);
  cairo_stroke(context);
}

void draw_columns(cairo_t* context, const FreeSpace& space, const MapView& view, int step,
                  const Colour& ink) {
  const double edge = view.y_up ? view.top + view.height + 0.5 : view.top - 0.5;
  const double outwards = view.y_up ? 1 : -1;
  for (int x = 0; x <= space.width(); x += step) {
    const double at = std::round(view.to_picture({static_cast<double>(x), 0}).x);
    draw_tick(context, {at + 0.5, edge}, {at + 0.5, edge + outwards * kAxisTick}, ink);
    const std::string number = std::to_string(x);
    const double baseline =
        edge + outwards * (kAxisTick + kAxisGap) + (view.y_up ? kAxisDigitHeight : 0);
    draw_text(context, {at - text_width(context, number) / 2, baseline}, number, ink);
  }
}

void draw_rows(cairo_t* context, const FreeSpace& space, const MapView& view, int step,
               const Colour& ink) {
  const double edge = view.left - 0.5;
  for (int y = 0; y <= space.height(); y += step) {
    const double at = std::round(view.to_picture({0, static_cast<double>(y)}).y);
    draw_tick(context, {edge, at + 0.5}, {edge - kAxisTick, at + 0.5}, ink);
    const std::string number = std::to_string(y);
    draw_text(
        context,
        {edge - kAxisTick - kAxisGap - text_width(context, number), at + kAxisDigitHeight / 2},
        number, ink);
  }
}

}  // namespace

void draw_axes(cairo_t* context, const Scene& scene, const MapView& view, const Style& style) {
  if (!scene.unit) return;
  const FreeSpace& space = scene.space;
  const int step = axis_step(scene, view.scale());
  select_label_font(context, kAxisFontSize);
  draw_columns(context, space, view, step, style.ink);
  draw_rows(context, space, view, step, style.ink);
}

}  // namespace wend
