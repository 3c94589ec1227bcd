#include "wend/render/legend.hpp"

#include <algorithm>

#include "wend/render/cell_paints.hpp"
#include "wend/render/text_glyphs.hpp"

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
    case LineRole::driven:
      break;
  }
  return Swatch::driven_line;
}

/// Each role once, in the enum's order.
void add_lines(const Scene& scene, const Style& style, std::vector<LegendItem>& items) {
  for (const LineRole role : {LineRole::planned, LineRole::smoothed, LineRole::driven}) {
    const auto is_it = [role](const SceneLine& line) { return line.role == role; };
    if (!std::ranges::any_of(scene.lines, is_it)) continue;
    items.push_back({swatch_of(role),
                     style.of(role),
                     std::string(describe(role)),
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
    add(mixed(style.slightly_rough, style.very_rough, roughness(kTypicallyRough)),
        scene.unit ? "rough road" : "rough", '~');
  }
  if (scene.space.map().unknown().count() > 0) add(style.unknown, "unknown", '?');
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
  for (const CellRole role : roles_in(scene)) {
    items.push_back({Swatch::role,
                     style.of(role),
                     std::string(describe(role)),
                     {},
                     glyph_of(role).text.front()});
  }
  add_cells(scene, style, items);
  return items;
}

}  // namespace wend
