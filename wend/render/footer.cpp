#include "wend/render/footer.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "wend/render/cell_paints.hpp"
#include "wend/render/label_font.hpp"
#include "wend/render/marks.hpp"
#include "wend/render/scale_bar.hpp"

namespace wend {
namespace {

constexpr double kFontSize = 17;
constexpr double kSwatch = 9;    // half a swatch's side, pixels
constexpr double kGap = 8;       // between a swatch and its label
constexpr double kItemGap = 26;  // between items
constexpr double kLongestBar = 200;
constexpr MarkSizes kMarkSizes{.line = 4, .halo = 1.5, .mark = 8};

enum class Shape { start, goal, line, square };

struct Item {
  Shape shape;
  Colour colour;
  std::string_view label;
};

/// Some cells that are no obstacles may not be entered.
bool has_too_close_cells(const FreeSpace& space) {
  return space.passable().count() + space.obstacles().count() < space.map().size();
}

std::vector<Item> items_of(const Scene& scene, const Style& style) {
  std::vector<Item> items;
  if (scene.start) items.push_back({Shape::start, style.start, "start"});
  if (!scene.goals.empty()) items.push_back({Shape::goal, style.goal, "goal"});
  if (scene.path.size() > 1) items.push_back({Shape::line, style.path, "path"});
  for (const CellRole role : roles_in(scene)) {
    items.push_back({Shape::square, style.of(role), describe(role)});
  }
  if (has_too_close_cells(scene.space)) {
    items.push_back({Shape::square, style.too_close, "too close"});
  }
  if (!scene.space.uniform_terrain()) {
    const Colour rough = mixed(style.slightly_rough, style.very_rough, roughness(3));
    items.push_back({Shape::square, rough, "rough"});
  }
  if (scene.space.map().unknown().count() > 0) {
    items.push_back({Shape::square, style.unknown, "unknown"});
  }
  return items;
}

double text_width(cairo_t* context, std::string_view text) {
  cairo_text_extents_t extents;
  cairo_text_extents(context, std::string(text).c_str(), &extents);
  return extents.x_advance;
}

double width_of(cairo_t* context, const Item& item) {
  return 2 * kSwatch + kGap + text_width(context, item.label);
}

void draw_text(cairo_t* context, Point baseline, std::string_view text, const Style& style) {
  set_source(context, style.ink);
  cairo_move_to(context, baseline.x, baseline.y);
  cairo_show_text(context, std::string(text).c_str());
}

void draw_swatch(cairo_t* context, Point centre, const Item& item, const Style& style) {
  switch (item.shape) {
    case Shape::start:
      return draw_start_mark(context, centre, kMarkSizes, style);
    case Shape::goal:
      return draw_goal_mark(context, centre, kMarkSizes, style);
    case Shape::line:
      set_source(context, item.colour);
      cairo_set_line_width(context, kMarkSizes.line);
      cairo_move_to(context, centre.x - kSwatch, centre.y);
      cairo_line_to(context, centre.x + kSwatch, centre.y);
      return cairo_stroke(context);
    case Shape::square:
      cairo_rectangle(context, centre.x - kSwatch, centre.y - kSwatch, 2 * kSwatch, 2 * kSwatch);
      set_source(context, item.colour);
      cairo_fill_preserve(context);
      set_source(context, style.ink, 0.5);
      cairo_set_line_width(context, 1);
      return cairo_stroke(context);
  }
}

/// From the right; the last items are left out where there is no room.
void draw_legend(cairo_t* context, std::vector<Item> items, Point right, double room,
                 const Style& style) {
  double width = -kItemGap;
  for (const Item& item : items) width += width_of(context, item) + kItemGap;
  while (!items.empty() && width > room) {
    width -= width_of(context, items.back()) + kItemGap;
    items.pop_back();
  }
  double x = right.x - width;
  for (const Item& item : items) {
    draw_swatch(context, {std::round(x + kSwatch), right.y}, item, style);
    draw_text(context, {x + 2 * kSwatch + kGap, right.y + 0.35 * kFontSize}, item.label, style);
    x += width_of(context, item) + kItemGap;
  }
}

/// Returns how wide it is with its label.
double draw_scale_bar(cairo_t* context, const ScaleBar& bar, Point left, const Style& style) {
  constexpr double kTick = 6;
  set_source(context, style.ink);
  cairo_set_line_width(context, 2);
  cairo_move_to(context, left.x + 1, left.y - kTick);
  cairo_line_to(context, left.x + 1, left.y + kTick);
  cairo_move_to(context, left.x + 1, left.y);
  cairo_line_to(context, left.x + bar.pixels - 1, left.y);
  cairo_move_to(context, left.x + bar.pixels - 1, left.y - kTick);
  cairo_line_to(context, left.x + bar.pixels - 1, left.y + kTick);
  cairo_stroke(context);
  draw_text(context, {left.x + bar.pixels + kGap, left.y + 0.35 * kFontSize}, bar.label, style);
  return bar.pixels + kGap + text_width(context, bar.label);
}

}  // namespace

void draw_footer(cairo_t* context, const Scene& scene, const PictureLayout& layout,
                 const Style& style) {
  select_label_font(context, kFontSize);
  constexpr double kLeft = PictureLayout::kMargin;
  const double right = layout.width - PictureLayout::kMargin;
  const double middle = layout.view.top + layout.view.height +
                        (PictureLayout::kMargin + PictureLayout::kFooter) / 2.0;
  const ScaleBar bar = scale_bar(scene.space.map().frame(), layout.view.scale(), kLongestBar);
  double used = 0;
  if (bar.pixels < layout.width / 2.0) {  // a map of one cell needs none
    used = draw_scale_bar(context, bar, {kLeft, middle}, style);
  }
  draw_legend(context, items_of(scene, style), {right, middle}, right - kLeft - used - 2 * kItemGap,
              style);
}

}  // namespace wend
