#include "wend/render/legend.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "wend/render/terminal/glyphs.hpp"

namespace wend {
namespace {

constexpr double kTypicallyRough = 3;  // the multiplier whose colour the legend shows

bool has_arrows(const Scene& scene) {
  return scene.arrows && std::ranges::any_of(scene.arrows->values(),
                                             [](const auto& arrow) { return arrow.has_value(); });
}

/// A line, or what a car drives in each gear.
void add_path(const Path& path, const Style& style, std::vector<LegendItem>& items) {
  const auto add_gears = [&](const JoinedPoses& /*joined*/) {
    const std::vector<Arc> arcs = path.arcs();
    const auto backs = [](const Arc& arc) { return arc.length < 0; };
    if (!std::ranges::all_of(arcs, backs)) {
      items.push_back({Swatch::driven, style.path, "driven ahead", {}, 'o'});
    }
    if (std::ranges::any_of(arcs, backs)) {
      items.push_back({Swatch::reverse, style.reverse, "in reverse", {}, '='});
    }
  };
  path.visit(add_gears, [&](const auto&) {
    if (path.size() > 1) items.push_back({Swatch::path, style.path, "path", {}, 'o'});
  });
}

/// Each role once, in the enum's order.
void add_lines(const Scene& scene, const Style& style, std::vector<LegendItem>& items) {
  for (std::size_t i = 0; i < kLineRoles; ++i) {
    const auto role = static_cast<LineRole>(i);
    const auto line = std::ranges::find(scene.lines, role, &SceneLine::role);
    if (line == scene.lines.end()) continue;
    const auto swatch = static_cast<Swatch>(static_cast<std::size_t>(Swatch::planned_line) + i);
    const char character = ascii_of(glyph_of(role).text).front();
    const std::string label(line->label.empty() ? describe(role) : line->label);
    items.push_back({swatch, style.of(role), label, {}, character});
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
  add_path(scene.path, style, items);
  add_lines(scene, style, items);
  add(has_arrows(scene), Swatch::arrow, style.arrows, "way to move", ' ');
}

/// Are there free cells where the robot cannot stand? Blocked cells in which it can put its base point do not count.
bool has_cells_too_close(const Scene& scene) {
  const BitGrid& blocked = scene.space.obstacles().blocked();
  std::uint64_t within = 0;
  for (int y = 0; y < blocked.height(); ++y) {
    const auto row = blocked.row_words(y);
    const auto standing = standable(scene).row_words(y);
    for (std::size_t i = 0; i < row.size(); ++i) within += std::popcount(row[i] | standing[i]);
  }
  return within < scene.space.map().size();
}

void add_cells(const Scene& scene, const Style& style, std::vector<LegendItem>& items) {
  const auto add = [&](const Colour& colour, const char* label, char character) {
    items.push_back({Swatch::cell, colour, label, {}, character});
  };
  if (scene.places.on_corners() && scene.space.obstacles().blocked().count() > 0)
    add(style.occupied, "obstacle", '#');
  if (has_cells_too_close(scene)) add(style.too_close, "too close", ':');
  if (!scene.heatmap && !scene.space.map().uniform_terrain()) {
    add(style.rough(kTypicallyRough), scene.places.on_corners() ? "rough road" : "rough", '~');
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
  for (const Cell cell : every_cell(scene.space)) {
    if (!is_rough(scene, cell)) continue;
    if (const auto role = role_of(scene, cell)) roles[static_cast<std::size_t>(*role)] = true;
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

std::vector<LegendItem> legend_of(std::span<const Scene> scenes, const Style& style) {
  std::vector<LegendItem> items;
  for (const Scene& scene : scenes) {
    for (LegendItem& item : legend_of(scene, style)) {
      if (std::ranges::find(items, item) != items.end()) continue;
      const auto place = std::ranges::upper_bound(items, item.swatch, {}, &LegendItem::swatch);
      items.insert(place, std::move(item));
    }
  }
  return items;
}

}  // namespace wend
