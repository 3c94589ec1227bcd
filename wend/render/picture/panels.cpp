#include "wend/render/picture/panels.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <vector>

#include "wend/render/picture/canvas.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

constexpr double kTitleSize = 20;
constexpr double kCaptionSize = 16;
constexpr int kPad = 12;  // around a panel on a page of its own

/// The panels, heatmaps of one title with one range.
std::vector<Panel> with_shared_ranges(std::span<const Panel> panels) {
  std::map<std::string, HeatRange> ranges;
  for (const Panel& panel : panels) {
    const auto& heatmap = panel.scene.heatmap;
    const auto range = heatmap ? range_of(*heatmap) : std::nullopt;
    if (!range) continue;
    HeatRange& shared = ranges.emplace(heatmap->title, *range).first->second;
    shared = {std::min(shared.least, range->least), std::max(shared.greatest, range->greatest)};
  }
  std::vector<Panel> shared(panels.begin(), panels.end());
  for (Panel& panel : shared) {
    auto& heatmap = panel.scene.heatmap;
    if (heatmap && ranges.contains(heatmap->title)) heatmap->range = ranges[heatmap->title];
  }
  return shared;
}

/// What the panels that share a style show, each entry once, in the order of one legend.
std::vector<LegendItem> shared_legend(std::span<const Panel> panels, const Style& style) {
  std::vector<Scene> scenes;
  for (const Panel& panel : panels) {
    if (!panel.style) scenes.push_back(panel.scene);
  }
  return legend_of(scenes, style);
}

/// Where all panels have the same one.
std::optional<ScaleBar> shared_bar(std::span<const Panel> panels, const PanelLayout& layout) {
  std::optional<ScaleBar> shared;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const MapView& view = layout.places[i].view;
    ScaleBar bar = scale_bar(panels[i].scene.space.map().frame(), view.scale());
    if ((shared && bar != *shared) || bar.pixels > layout.width / 3.0) return std::nullopt;
    shared = std::move(bar);
  }
  return shared;
}

constexpr std::size_t kMostCaptionLines = 6;

/// For how many lines a caption has room however wide the panel is.
std::size_t least_lines(std::string_view caption) {
  if (caption.empty()) return 0;
  return static_cast<std::size_t>(
      std::max<std::ptrdiff_t>(2, std::ranges::count(caption, '\n') + 1));
}

double height_of_lines(std::size_t lines) {
  return lines == 0 ? 0 : static_cast<double>(lines) * PanelLayout::kCaptionLine + 4;
}

/// The text's lines, broken between words; the last one that there may be is shortened.
std::vector<std::string> caption_lines(cairo_t* context, std::string_view text, double room) {
  std::vector<std::string> lines;
  while (!text.empty() && lines.size() < kMostCaptionLines) {
    std::size_t end = std::min(text.find('\n'), text.size());
    const bool last = lines.size() + 1 == kMostCaptionLines;
    while (!last && text_width(context, text.substr(0, end)) > room) {
      const std::size_t blank = text.substr(0, end).rfind(' ');
      if (blank == std::string_view::npos || blank == 0) break;
      end = blank;
    }
    lines.push_back(shortened(context, text.substr(0, end), room));
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return lines;
}

/// The legend of a panel with a style of its own.
Footer own_footer(const Scene& scene, const Style& style, double width) {
  return {legend_of(scene, style), std::nullopt, width};
}

/// How many lines the longest caption takes below the maps of this layout.
std::size_t lines_of_captions(std::span<const Panel> panels, const PanelLayout& layout) {
  std::size_t most = 0;
  with_label_font(kCaptionSize, [&](cairo_t* context) {
    for (std::size_t i = 0; i < panels.size(); ++i) {
      const std::string& caption = panels[i].caption;
      const auto lines = caption_lines(context, caption, layout.places[i].width);
      most = std::max({most, lines.size(), least_lines(caption)});
    }
  });
  return most;
}

/// Captions and legends need room below the maps, and how much depends on how wide the panels are.
PanelLayout layout_of(std::span<const Panel> panels) {
  std::size_t captions = 0;
  for (const Panel& panel : panels) captions = std::max(captions, least_lines(panel.caption));
  const PanelLayout layout = panel_layout(panels, height_of_lines(captions));
  int lines = 0;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels[i];
    if (!panel.style) continue;
    lines = std::max(lines, own_footer(panel.scene, *panel.style, layout.places[i].width).lines());
  }
  const auto columns = static_cast<int>(std::ranges::count_if(
      layout.places, [&](const PanelPlace& place) { return place.top == layout.places[0].top; }));
  const double below = height_of_lines(lines_of_captions(panels, layout));
  return panel_layout(panels, below + lines * Footer::kLine, columns);
}

void draw_panel(cairo_t* context, const Panel& panel, const PanelPlace& place, const Style& style,
                PictureKind kind) {
  if (panel.style) {
    cairo_rectangle(context, place.left - kPad, place.top - kPad, place.width + 2 * kPad,
                    place.height + 2 * kPad);
    fill(context, style.page);
  }
  select_label_font(context, kTitleSize);
  draw_text(context, {place.left, place.top + kTitleSize},
            shortened(context, panel.title, place.width), style.ink);
  draw_scene(context, panel.scene, place.view, style, kind);
  double y = place.view.bottom() + place.axes.bottom + PanelLayout::kCaptionLine;
  select_label_font(context, kCaptionSize);
  for (const std::string& line : caption_lines(context, panel.caption, place.width)) {
    draw_text(context, {place.left, y}, line, style.ink);
    y += PanelLayout::kCaptionLine;
  }
  if (!panel.style) return;
  const Footer footer = own_footer(panel.scene, *panel.style, place.width);
  const double middle = (footer.lines() - 0.5) * Footer::kLine;
  footer.draw(context, {place.left, place.top + place.height - middle}, style);
}

}  // namespace

Expected<std::string, Error> draw_panels(std::span<const Panel> panels, PictureKind kind,
                                         const Style& style) {
  assert(!panels.empty());
  const std::vector<Panel> shared = with_shared_ranges(panels);
  const PanelLayout layout = layout_of(shared);
  const double room = layout.width - 2 * PanelLayout::kMargin;
  std::vector<LegendItem> legend = shared_legend(shared, style);
  std::optional<ScaleBar> bar = shared_bar(shared, layout);
  const bool explains = !legend.empty() || bar;
  const Footer footer(std::move(legend), std::move(bar), room);
  const int height = layout.height + (explains ? footer.lines() * Footer::kLine : 0);
  return drawn_file(kind, layout.width, height, style.page, [&](cairo_t* context) {
    for (std::size_t i = 0; i < shared.size(); ++i) {
      draw_panel(context, shared[i], layout.places[i], shared[i].style.value_or(style), kind);
    }
    const double below = layout.height - PanelLayout::kMargin / 2.0 + Footer::kLine / 2.0;
    footer.draw(context, {PanelLayout::kMargin, below}, style);
  });
}

}  // namespace wend
