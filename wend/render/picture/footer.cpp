#include "wend/render/picture/footer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "wend/render/number_text.hpp"
#include "wend/render/picture/arrows.hpp"
#include "wend/render/picture/driven_path.hpp"
#include "wend/render/picture/labels.hpp"
#include "wend/render/picture/marks.hpp"
#include "wend/render/picture/scene_lines.hpp"
#include "wend/render/picture/stripes.hpp"

namespace wend {
namespace {

constexpr double kFontSize = 17;
constexpr double kBaseline = 0.35 * kFontSize;  // below the middle of a line
constexpr double kSwatch = 9;                   // half a swatch's side, pixels
constexpr double kSwatchGap = 8;                // between a swatch and its label
constexpr double kItemGap = 26;                 // between items
constexpr double kHeatBar = 130;                // long
constexpr double kSlack = 4;  // a font is not exactly as wide on every kind of surface
constexpr MarkSizes kMarkSizes{.line = 4, .halo = 1.5, .mark = 8};

double heat_width(cairo_t* context, const LegendItem& item) {
  return kHeatBar + 2 * kSwatchGap + text_width(context, short_number(item.range.least)) +
         text_width(context, short_number(item.range.greatest));
}

/// Dashes need some room.
double swatch_width(Swatch swatch) {
  const bool is_long = swatch == Swatch::driven || swatch == Swatch::reverse ||
                       swatch == Swatch::planned_line || swatch == Swatch::smoothed_line ||
                       swatch == Swatch::driven_line || swatch == Swatch::possible_line;
  return is_long ? 4 * kSwatch : 2 * kSwatch;
}

double width_of(cairo_t* context, const LegendItem& item) {
  const double swatch = item.swatch == Swatch::heat ? heat_width(context, item) + kSwatchGap
                                                    : swatch_width(item.swatch);
  return swatch + kSwatchGap + text_width(context, item.label);
}

void outline(cairo_t* context, const Style& style) {
  set_source(context, style.ink, 0.5);
  cairo_set_line_width(context, 1);
  cairo_stroke(context);
}

/// Title, least value, bar, greatest value.
void draw_heat(cairo_t* context, Point left, const LegendItem& item, const Style& style) {
  const auto write = [&](std::string_view text, double gap) {
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
  outline(context, style);
  left.x += kHeatBar + kSwatchGap;
  write(short_number(item.range.greatest), 0);
}

void draw_cell_swatch(cairo_t* context, Point centre, const LegendItem& item, const Style& style) {
  const PictureArea area{centre.x - kSwatch, centre.y - kSwatch, 2 * kSwatch, 2 * kSwatch};
  if (item.stripes) draw_stripes(context, area, *item.stripes);
  cairo_rectangle(context, area.left, area.top, area.width, area.height);
  if (!item.stripes) {
    set_source(context, item.colour);
    cairo_fill_preserve(context);
  }
  outline(context, style);
}

void draw_swatch(cairo_t* context, Point centre, const LegendItem& item, const Style& style) {
  switch (item.swatch) {
    case Swatch::heat:
      return;  // draw_heat() draws it
    case Swatch::start:
      return draw_start_mark(context, {centre}, kMarkSizes, style);
    case Swatch::goal:
      return draw_goal_mark(context, {centre}, kMarkSizes, style);
    case Swatch::narrowest:
      return draw_narrowest_mark(context, centre,
                                 {.line = 3, .halo = 1, .mark = kSwatch / kNarrowestReach}, style);
    case Swatch::nearest_free:
      return draw_nearest_free_mark(context, centre, kMarkSizes, style);
    case Swatch::path:
      set_source(context, item.colour);
      cairo_set_line_width(context, kMarkSizes.line);
      cairo_move_to(context, centre.x - kSwatch, centre.y);
      cairo_line_to(context, centre.x + kSwatch, centre.y);
      return cairo_stroke(context);
    case Swatch::driven:
    case Swatch::reverse:
      return draw_driven_sample(context, centre, swatch_width(item.swatch),
                                item.swatch == Swatch::reverse, style);
    case Swatch::collision:
      return draw_collision_mark(context, centre, kMarkSizes, style);
    case Swatch::planned_line:
      return draw_line_sample(context, centre, swatch_width(item.swatch), LineRole::planned, style);
    case Swatch::smoothed_line:
      return draw_line_sample(context, centre, swatch_width(item.swatch), LineRole::smoothed,
                              style);
    case Swatch::driven_line:
      return draw_line_sample(context, centre, swatch_width(item.swatch), LineRole::driven, style);
    case Swatch::possible_line:
      return draw_line_sample(context, centre, swatch_width(item.swatch), LineRole::possible,
                              style);
    case Swatch::arrow:
      return draw_arrow(context, centre, 2 * kSwatch, Direction::right, item.colour);
    case Swatch::role:
    case Swatch::cell:
      return draw_cell_swatch(context, centre, item, style);
  }
}

void draw_item(cairo_t* context, Point left, const LegendItem& item, const Style& style) {
  if (item.swatch == Swatch::heat) return draw_heat(context, left, item, style);
  const double swatch = swatch_width(item.swatch);
  draw_swatch(context, {std::round(left.x + swatch / 2), left.y}, item, style);
  draw_text(context, {left.x + swatch + kSwatchGap, left.y + kBaseline}, item.label, style.ink);
}

void draw_scale_bar(cairo_t* context, const ScaleBar& bar, Point left, const Style& style) {
  constexpr double kTick = 6;
  set_source(context, style.ink);
  cairo_set_line_width(context, 2);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  for (const double x : {left.x + 1, left.x + bar.pixels - 1}) {
    cairo_move_to(context, x, left.y - kTick);
    cairo_line_to(context, x, left.y + kTick);
  }
  cairo_move_to(context, left.x + 1, left.y);
  cairo_line_to(context, left.x + bar.pixels - 1, left.y);
  cairo_stroke(context);
  draw_text(context, {left.x + bar.pixels + kSwatchGap, left.y + kBaseline}, bar.label, style.ink);
}

double width_of_row(cairo_t* context, const std::vector<LegendItem>& row) {
  double width = row.empty() ? 0 : -kItemGap;
  for (const LegendItem& item : row) width += width_of(context, item) + kItemGap;
  return width;
}

}  // namespace

Footer::Footer(std::vector<LegendItem> legend, std::optional<ScaleBar> bar, double width)
    : bar_(std::move(bar)), rows_(1), width_(width) {
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1));
  const CairoContext context(cairo_create(surface.get()));
  select_label_font(context.get(), kFontSize);
  double room = width - kSlack;
  if (bar_)
    room -= bar_->pixels + kSwatchGap + text_width(context.get(), bar_->label) + 2 * kItemGap;
  for (LegendItem& item : legend) {
    const double label = text_width(context.get(), item.label);
    const double rest = width_of(context.get(), item) - label;
    item.label = shortened(context.get(), item.label, width - kSlack - rest);
    rows_.back().push_back(std::move(item));
    if (width_of_row(context.get(), rows_.back()) <= room) continue;
    if (rows_.size() > 1 && rows_.back().size() == 1) continue;  // it is as short as it gets
    LegendItem last = std::move(rows_.back().back());
    rows_.back().pop_back();
    rows_.push_back({std::move(last)});
    room = width - kSlack;
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
