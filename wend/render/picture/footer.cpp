
#include <cmath>

#include "wend/render/heatmap.hpp"
#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

constexpr double kFontSize = 17;
constexpr double kBaseline = 0.35 * kFontSize;  // below the middle of a line
constexpr double kSwatch = 9;                   // half a swatch's side, pixels
constexpr double kSwatchGap = 8;                // between a swatch and its label
constexpr double kItemGap = 26;                 // between items
constexpr double kHeatBar = 130;                // long
constexpr double kSlack = 4;  // a font is not exactly as wide on every kind of surface

double heat_width(cairo_t* context, const LegendItem& item) {
  return kHeatBar + 2 * kSwatchGap + text_width(context, short_number(item.range.least)) +
         text_width(context, short_number(item.range.greatest));
}

/// Dashes need some room.
double swatch_width(const LegendItem& item) {
  const bool is_long =
      item.swatch == Swatch::driven || item.swatch == Swatch::reverse || item.line().has_value();
  return is_long ? 4 * kSwatch : 2 * kSwatch;
}

double width_of(cairo_t* context, const LegendItem& item) {
  const double swatch =
      item.swatch == Swatch::heat ? heat_width(context, item) + kSwatchGap : swatch_width(item);
  return swatch + kSwatchGap + text_width(context, item.label);
}

/// Title, least value, bar, greatest value.
void draw_heat(cairo_t* context, Point left, const LegendItem& item, const Style& style) {
  const auto write = [&](const std::string& text, double gap) {
    draw_text(context, {left.x, left.y + kBaseline}, text, style.ink);
    left.x += text_width(context, text) + gap;
  };
  write(item.label, 2 * kSwatchGap);
  write(short_number(item.range.least), kSwatchGap);
  left.x = std::round(left.x);
  cairo_pattern_t* const colours = cairo_pattern_create_linear(left.x, 0, left.x + kHeatBar, 0);
  for (std::size_t i = 0; i < style.heat_colours.size(); ++i) {
    const double share =
        static_cast<double>(i) / static_cast<double>(style.heat_colours.size() - 1);
    const Colour colour = style.heat(share);
    cairo_pattern_add_color_stop_rgb(colours, share, colour.red, colour.green, colour.blue);
  }
  cairo_rectangle(context, left.x, left.y - kSwatch, kHeatBar, 2 * kSwatch);
  cairo_set_source(context, colours);
  cairo_fill_preserve(context);
  cairo_pattern_destroy(colours);
  stroke(context, 1, style.ink, 0.5);
  left.x += kHeatBar + kSwatchGap;
  write(short_number(item.range.greatest), 0);
}

void draw_cell_swatch(cairo_t* context, Point centre, const LegendItem& item, const Style& style) {
  const PictureArea area{centre.x - kSwatch, centre.y - kSwatch, 2 * kSwatch, 2 * kSwatch};
  if (item.stripes) draw_stripes(context, area, *item.stripes);
  trace_area(context, area);
  if (!item.stripes) fill_and_keep(context, item.colour);
  stroke(context, 1, style.ink, 0.5);
}

void draw_swatch(cairo_t* context, Point centre, const LegendItem& item, const Style& style) {
  const double length = swatch_width(item);
  Pen pen{context, {.line = 4, .halo = 1.5, .mark = 8}, style};
  if (const auto role = item.line()) return draw_line_sample(pen, centre, length, *role);
  switch (item.swatch) {
    case Swatch::narrowest:
      pen.sizes = {.line = 3, .halo = 1, .mark = kSwatch / kNarrowestReach};
      [[fallthrough]];
    case Swatch::start:
    case Swatch::goal:
    case Swatch::nearest_free:
    case Swatch::collision:
      return draw_mark(pen, item.swatch, centre);
    case Swatch::path:
      trace_line(context, {centre.x - kSwatch, centre.y}, {centre.x + kSwatch, centre.y});
      return stroke(context, pen.sizes.line, item.colour);
    case Swatch::driven:
    case Swatch::reverse:
      return draw_driven_sample(pen, centre, length, item.swatch == Swatch::reverse);
    case Swatch::arrow:
      return draw_arrow(context, centre, 2 * kSwatch, Direction::plus_x, item.colour);
    default:
      return draw_cell_swatch(context, centre, item, style);
  }
}

void draw_item(cairo_t* context, Point left, const LegendItem& item, const Style& style) {
  if (item.swatch == Swatch::heat) return draw_heat(context, left, item, style);
  const double swatch = swatch_width(item);
  draw_swatch(context, {std::round(left.x + swatch / 2), left.y}, item, style);
  draw_text(context, {left.x + swatch + kSwatchGap, left.y + kBaseline}, item.label, style.ink);
}

void draw_scale_bar(cairo_t* context, const ScaleBar& bar, Point left, const Style& style) {
  constexpr double kBarTick = 6;
  const double right = left.x + bar.pixels;
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  for (const double x : {left.x + 1, right - 1}) {
    trace_line(context, {x, left.y - kBarTick}, {x, left.y + kBarTick});
  }
  trace_line(context, {left.x + 1, left.y}, {right - 1, left.y});
  stroke(context, 2, style.ink);
  draw_text(context, {right + kSwatchGap, left.y + kBaseline}, bar.label, style.ink);
}

double width_of_row(cairo_t* context, const std::vector<LegendItem>& row) {
  double width = row.empty() ? 0 : -kItemGap;
  for (const LegendItem& item : row) width += width_of(context, item) + kItemGap;
  return width;
}

}  // namespace

Footer::Footer(std::vector<LegendItem> legend, std::optional<ScaleBar> bar, double width)
    : bar_(std::move(bar)), rows_(1), width_(width) {
  with_label_font(kFontSize, [&](cairo_t* context) { arrange(context, std::move(legend)); });
}

void Footer::arrange(cairo_t* context, std::vector<LegendItem> legend) {
  double room = width_ - kSlack;
  if (bar_) room -= bar_->pixels + kSwatchGap + text_width(context, bar_->label) + 2 * kItemGap;
  for (LegendItem& item : legend) {
    const double rest = width_of(context, item) - text_width(context, item.label);
    item.label = shortened(context, item.label, width_ - kSlack - rest);
    rows_.back().push_back(std::move(item));
    if (width_of_row(context, rows_.back()) <= room) continue;
    if (rows_.size() > 1 && rows_.back().size() == 1) continue;  // it is as short as it gets
    LegendItem last = std::move(rows_.back().back());
    rows_.back().pop_back();
    rows_.push_back({std::move(last)});
    room = width_ - kSlack;
  }
}

void Footer::draw(cairo_t* context, Point left, const Style& style) const {
  select_label_font(context, kFontSize);
  if (bar_) draw_scale_bar(context, *bar_, left, style);
  double y = left.y;
  for (const auto& row : rows_) {
    double x = left.x + width_ - width_of_row(context, row);
    for (const LegendItem& item : row) {
      draw_item(context, {x, y}, item, style);
      x += width_of(context, item) + kItemGap;
    }
    y += kLine;
  }
}

}  // namespace wend
