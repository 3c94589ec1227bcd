#include "wend/render/terminal/terminal_picture.hpp"

#include <chafa.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "wend/render/heatmap.hpp"
#include "wend/render/legend.hpp"
#include "wend/render/picture/canvas.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/picture/scene_drawing.hpp"

namespace wend {
namespace {

struct ChafaDeleter {
  void operator()(ChafaSymbolMap* map) const { chafa_symbol_map_unref(map); }
  void operator()(ChafaCanvasConfig* config) const { chafa_canvas_config_unref(config); }
  void operator()(ChafaCanvas* canvas) const { chafa_canvas_unref(canvas); }
  void operator()(ChafaTermInfo* info) const { chafa_term_info_unref(info); }
  void operator()(GString* text) const { g_string_free(text, TRUE); }
};

template <class T>
using Owned = std::unique_ptr<T, ChafaDeleter>;

// Chafa matches symbols on 8 x 8 pixels a character; an image of that size is not scaled again.
constexpr int kSymbolPixels = 8;

constexpr double kMostCellsAPixel = 2;  // along its side: a wall one cell wide is still seen

// More than any terminal has; less than what cairo refuses.
constexpr int kMostCharacters = 400;         // across, and down
constexpr int kMostPixelsPerCharacter = 64;  // a character

/// Pixels of a character that a picture is drawn with: half blocks are one wide and two high.
struct CharacterSize {
  int width;
  int height;
};

bool has_blocks(const Terminal& terminal) {
  return terminal.graphics == TerminalGraphics::half_blocks;
}

CharacterSize character_size(const Terminal& terminal) {
  if (terminal.plain() || has_blocks(terminal)) return {1, 2};
  return {std::clamp(terminal.cell_width, 1, kMostPixelsPerCharacter),
          std::clamp(terminal.cell_height, 1, kMostPixelsPerCharacter)};
}

/// With sixteen colours the marks take the pure ones, or they would all come out as one. A mark of one pixel must not
/// be taken for a wall.
Style suited(const Scene& scene, const Style& style, const Terminal& terminal) {
  Style shown = style_for(scene, style);
  if (has_blocks(terminal)) shown.narrowest = colour_from(0xF000C0);
  if (terminal.colours == TerminalColours::sixteen) {
    shown.path = colour_from(0x0000FF);
    shown.start = colour_from(0x00A000);
    shown.goal = colour_from(0xFF0000);
    shown.lines = {.planned = colour_from(0xE00000),
                   .smoothed = colour_from(0x00A000),
                   .driven = colour_from(0x0000FF)};
  }
  return shown;
}

/// The scene on an image of `width` x `height` pixels; what the map does not cover is transparent.
CairoSurface scene_image(const Scene& scene, const MapView& view, int width, int height,
                         const MarkSizes& sizes, const Style& style) {
  CairoSurface surface = new_image(CAIRO_FORMAT_ARGB32, width, height);
  const CairoContext context(cairo_create(surface.get()));
  const SceneDrawing drawing{{context.get(), sizes, style}, scene, view};
  cairo_rectangle(context.get(), view.left, view.top, view.width, view.height);
  cairo_clip(context.get());
  const bool blocks = sizes.halo <= 0;
  // Mixtures of colours in few large pixels are hard to read.
  if (blocks) cairo_set_antialias(context.get(), CAIRO_ANTIALIAS_NONE);
  const bool dominant = blocks && view.scale() < 1 && !scene.heatmap;
  dominant ? draw_dominant_map(drawing) : draw_map(drawing, PictureKind::png);
  if (!blocks) draw_arrows(drawing, false);  // half blocks have no room for arrows
  draw_path(drawing);
  draw_sparse_cells(drawing);
  draw_marks(drawing);
  cairo_surface_flush(surface.get());
  return surface;
}

/// Every pixel as many, so that chafa need not scale (it would blur).
CairoSurface enlarged(cairo_surface_t* image, int across, int down) {
  CairoSurface surface =
      new_image(CAIRO_FORMAT_ARGB32, cairo_image_surface_get_width(image) * across,
                cairo_image_surface_get_height(image) * down);
  const CairoContext context(cairo_create(surface.get()));
  cairo_scale(context.get(), across, down);
  cairo_set_source_surface(context.get(), image, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(context.get()), CAIRO_FILTER_NEAREST);
  cairo_paint(context.get());
  cairo_surface_flush(surface.get());
  return surface;
}

ChafaCanvasMode canvas_mode(const Terminal& terminal) {
  if (terminal.graphics == TerminalGraphics::kitty) return CHAFA_CANVAS_MODE_TRUECOLOR;
  // A palette made for the picture would leave out the colours of small marks.
  if (terminal.graphics == TerminalGraphics::sixel) return CHAFA_CANVAS_MODE_INDEXED_240;
  if (terminal.colours == TerminalColours::sixteen) return CHAFA_CANVAS_MODE_INDEXED_16;
  if (terminal.colours == TerminalColours::true_colour) return CHAFA_CANVAS_MODE_TRUECOLOR;
  return CHAFA_CANVAS_MODE_INDEXED_240;  // of 256 colours, 16 are the user's own
}

ChafaPixelMode pixel_mode(TerminalGraphics graphics) {
  if (graphics == TerminalGraphics::kitty) return CHAFA_PIXEL_MODE_KITTY;
  if (graphics == TerminalGraphics::sixel) return CHAFA_PIXEL_MODE_SIXELS;
  return CHAFA_PIXEL_MODE_SYMBOLS;
}

Owned<ChafaCanvasConfig> canvas_config(int columns, int rows, const Terminal& terminal) {
  Owned<ChafaCanvasConfig> config(chafa_canvas_config_new());
  const CharacterSize character = character_size(terminal);
  chafa_canvas_config_set_geometry(config.get(), columns, rows);
  chafa_canvas_config_set_pixel_mode(config.get(), pixel_mode(terminal.graphics));
  chafa_canvas_config_set_preprocessing_enabled(config.get(), FALSE);
  chafa_canvas_config_set_work_factor(config.get(), 1);
  chafa_canvas_config_set_canvas_mode(config.get(), canvas_mode(terminal));
  if (has_blocks(terminal)) {
    const Owned<ChafaSymbolMap> symbols(chafa_symbol_map_new());
    // Space, and the lower half: chafa names the halves by the axis along which they lie.
    const int tags = CHAFA_SYMBOL_TAG_SPACE | CHAFA_SYMBOL_TAG_VHALF;
    chafa_symbol_map_add_by_tags(symbols.get(), static_cast<ChafaSymbolTags>(tags));
    chafa_canvas_config_set_symbol_map(config.get(), symbols.get());
  } else {
    chafa_canvas_config_set_cell_geometry(config.get(), character.width, character.height);
  }
  return config;
}

std::string printed(cairo_surface_t* image, const ChafaCanvasConfig* config) {
  const Owned<ChafaCanvas> canvas(chafa_canvas_new(config));
  chafa_canvas_draw_all_pixels(
      canvas.get(), CHAFA_PIXEL_BGRA8_PREMULTIPLIED, cairo_image_surface_get_data(image),
      cairo_image_surface_get_width(image), cairo_image_surface_get_height(image),
      cairo_image_surface_get_stride(image));
  // A terminal that has every sequence; chafa hands over a new one each time.
  const Owned<ChafaTermInfo> sequences(
      chafa_term_db_get_fallback_info(chafa_term_db_get_default()));
  const Owned<GString> text(chafa_canvas_print(canvas.get(), sequences.get()));
  std::string result(text->str, text->len);
  if (!result.ends_with('\n')) result += '\n';
  return result;
}

// The legend.

constexpr int kShortestBar = 4;  // characters
constexpr int kLongestBar = 20;

std::string plain_entry(const LegendItem& item) {
  if (item.swatch != Swatch::heat) return std::string(1, item.character) + " " + item.label;
  return "0-9 " + item.label + ", " + short_number(item.range.least) + " to " +
         short_number(item.range.greatest);
}

std::string coloured_entry(const LegendItem& item, int columns, TerminalColours colours,
                           const Style& style) {
  if (item.swatch != Swatch::heat) {
    return ansi_background(item.colour, colours) + "  " + kAnsiReset + " " + item.label;
  }
  const std::string before = item.label + "  " + short_number(item.range.least) + " ";
  const std::string after = " " + short_number(item.range.greatest);
  const int room = columns - static_cast<int>(columns_of(before + after));
  const int length = std::clamp(room, kShortestBar, kLongestBar);
  std::string bar;
  for (int i = 0; i < length; ++i) {
    bar += ansi_background(style.heat(static_cast<double>(i) / (length - 1)), colours) + " ";
  }
  return before + bar + kAnsiReset + after;
}

}  // namespace

std::string terminal_shortage(const Scene& scene, int columns, int rows, const Terminal& terminal) {
  columns = std::clamp(columns, 1, kMostCharacters);
  rows = std::clamp(rows, 1, kMostCharacters);
  const CharacterSize character = character_size(terminal);
  const double across = static_cast<double>(scene.space.width()) / (columns * character.width);
  const double down = static_cast<double>(scene.space.height()) / (rows * character.height);
  const double cells = std::max(across, down);  // along the side of a pixel
  if (cells <= kMostCellsAPixel) return {};
  const auto whole = static_cast<int>(std::ceil(cells));
  const bool pixels =
      terminal.graphics == TerminalGraphics::kitty || terminal.graphics == TerminalGraphics::sixel;
  return "too small: " + std::to_string(whole) + " x " +
         std::to_string(pixels ? whole : 2 * whole) + " cells a " +
         (pixels ? "pixel" : "character") + "; a " + (across >= down ? "wider" : "higher") +
         " terminal or -o FILE.png shows more";
}

std::string terminal_picture(const Scene& scene, int columns, int rows, const Terminal& terminal,
                             const Style& style) {
  columns = std::clamp(columns, 1, kMostCharacters);
  rows = std::clamp(rows, 1, kMostCharacters);
  if (terminal.plain()) return ascii_picture(scene, columns, rows);
  const CharacterSize character = character_size(terminal);
  const bool blocks = has_blocks(terminal);
  const MapView view = fitted_view(scene.space.map(), columns * character.width,
                                   rows * character.height, blocks ? 1 : 3);
  const int used_columns = (view.width + character.width - 1) / character.width;
  const int used_rows = (view.height + character.height - 1) / character.height;
  const MarkSizes sizes = blocks ? block_mark_sizes(view) : mark_sizes(scene, view);
  CairoSurface image =
      scene_image(scene, view, used_columns * character.width, used_rows * character.height, sizes,
                  suited(scene, style, terminal));
  if (blocks) image = enlarged(image.get(), kSymbolPixels, kSymbolPixels / 2);
  return printed(image.get(), canvas_config(used_columns, used_rows, terminal).get());
}

std::string terminal_legend(const Scene& scene, int columns, const Terminal& terminal,
                            const Style& style) {
  const Style shown = suited(scene, style, terminal);
  std::vector<std::string> entries;
  for (const LegendItem& item : legend_of(scene, shown)) {
    if (terminal.plain()) {
      if (item.swatch == Swatch::heat || item.character != ' ')
        entries.push_back(plain_entry(item));
    } else if (item.swatch != Swatch::arrow || !has_blocks(terminal)) {
      entries.push_back(coloured_entry(item, columns, terminal.colours, shown));
    }
  }
  return entries.empty() ? "" : in_lines(entries, columns) + "\n";
}

}  // namespace wend
