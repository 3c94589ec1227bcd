#include "wend/render/legend.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "wend/render/picture/cell_paints.hpp"
#include "wend/render/terminal/text_glyphs.hpp"

namespace wend {
namespace {

constexpr double kTypicallyRough = 3;  // the multiplier whose colour the legend shows

/// Some cells that are no obstacles may not be entered.
bool has_too_close_cells(const FreeSpace& space) {
  return space.passable().count() + space.obstacles().count() < space.map().size();
}

bool has_arrows(const Scene& scene) {
  return scene.arrows && std::ranges::any_of(scene.arrows->values(),
                                             [](const auto& arrow) { return arrow.has_value(); });
}

bool drives(const Path& path, bool reverse) {
  return std::ranges::any_of(path.arcs(),
                             [&](const Arc& arc) { return (arc.length < 0) == reverse; });
}

constexpr Swatch swatch_of(LineRole role) {
  switch (role) {
    case LineRole::planned:
      return Swatch::planned_line;
    case LineRole::smoothed:
      return Swatch::smoothed_line;
    case LineRole::possible:
      return Swatch::possible_line;
    case LineRole::driven:
      break;
  }
  return Swatch::driven_line;
}

/// Each role once, in the enum's order.
void add_lines(const Scene& scene, const Style& style, std::vector<LegendItem>& items) {
  for (const LineRole role :
       {LineRole::planned, LineRole::smoothed, LineRole::driven, LineRole::possible}) {
    const auto line = std::ranges::find(scene.lines, role, &SceneLine::role);
    if (line == scene.lines.end()) continue;
    items.push_back({swatch_of(role),
                     style.of(role),
                     label_of(*line),
                     {},
                     ascii_of(glyph_of(role).text).front()});
  }
}

void add_marks(const Scene& scene, const Style& style, std::vector<LegendItem>& items) {
  const auto add = [&](bool wanted, Swatch swatch, const Colour& colour, const char* label,
                       char character) {
    if (wanted) items.push_back({swatch, colour, label, {}, character});
  };
  add(scene.start.has_value(), Swatch::start, style.start, "start", 'S');
  add(!scene.goals.empty(), Swatch::goal, style.goal, "goal", 'G');
  add(scene.narrowest.has_value(), Swatch::narrowest, style.narrowest, "narrowest", '!');
  add(!scene.nearest_free.empty(), Swatch::nearest_free, style.narrowest, "nearest free cell", 'N');
  add(scene.collision.has_value(), Swatch::collision, style.narrowest, "collision", 'X');
  const bool driven = scene.path.driven();
  add(!driven && scene.path.size() > 1, Swatch::path, style.path, "path", 'o');
  add(driven && drives(scene.path, false), Swatch::driven, style.path, "driven ahead", 'o');
  add(driven && drives(scene.path, true), Swatch::reverse, style.reverse, "in reverse", '=');
  add_lines(scene, style, items);
  add(has_arrows(scene), Swatch::arrow, style.arrows, "way to move", ' ');
}

void add_cells(const Scene& scene, const Style& style, std::vector<LegendItem>& items) {
  const auto add = [&](const Colour& colour, const char* label, char character) {
    items.push_back({Swatch::cell, colour, label, {}, character});
  };
  if (scene.unit && scene.space.obstacles().count() > 0) add(style.occupied, "obstacle", '#');
  if (has_too_close_cells(scene.space)) add(style.too_close, "too close", ':');
  if (!scene.heatmap && !scene.space.map().uniform_terrain()) {
    add(style.rough(kTypicallyRough), scene.unit ? "rough road" : "rough", '~');
    if (style.stripes_all_rough) {
      items.back().stripes = {style.rough(kTypicallyRough), style.stripe(kTypicallyRough)};
    }
  }
  if (scene.space.map().unknown().count() > 0) add(style.unknown, "unknown", '?');
}

/// By role.
std::array<bool, kCellRoles> roles_on_rough_ground(const Scene& scene) {
  std::array<bool, kCellRoles> roles{};
  if (scene.heatmap || scene.marked.empty() || scene.space.map().uniform_terrain()) return roles;
  for (int y = 0; y < scene.space.height(); ++y) {
    for (int x = 0; x < scene.space.width(); ++x) {
      if (!is_rough(scene, {x, y})) continue;
      if (const auto role = role_of(scene, {x, y})) roles[static_cast<std::size_t>(*role)] = true;
    }
  }
  return roles;
}

}  // namespace

std::vector<LegendItem> legend_of(const Scene& scene, const Style& wanted) {
  const Style style = style_for(scene, wanted);
  std::vector<LegendItem> items;
  if (scene.heatmap) {
    if (const auto range = range_of(*scene.heatmap)) {
      items.push_back({Swatch::heat, style.heat(1), scene.heatmap->title, *range});
    }
  }
  add_marks(scene, style, items);
  const auto striped = roles_on_rough_ground(scene);
  for (const CellRole role : roles_in(scene)) {
    const std::string name(describe(role));
    items.push_back({Swatch::role, style.of(role), name, {}, glyph_of(role).text.front()});
    if (!striped[static_cast<std::size_t>(role)]) continue;
    items.push_back({Swatch::role,
                     style.of(role, kTypicallyRough),
                     name + ", rough",
                     {},
                     ' ',
                     Stripes{style.of(role), style.stripe(kTypicallyRough)}});
  }
  add_cells(scene, style, items);
  return items;
}

}  // namespace wend
