#include "wend/render/terminal/terminal_picture.hpp"

#include <chafa.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

#include "wend/render/picture/arrows.hpp"
#include "wend/render/picture/cairo_objects.hpp"
#include "wend/render/picture/cell_paints.hpp"
#include "wend/render/picture/map_image.hpp"
#include "wend/render/picture/marks.hpp"
#include "wend/render/picture/picture_layout.hpp"
#include "wend/render/picture/sparse_dots.hpp"
#include "wend/render/terminal/ascii_picture.hpp"

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

std::string_view variable(const char* const* environment, std::string_view name) {
  for (; *environment != nullptr; ++environment) {
    const std::string_view entry = *environment;
    if (entry.size() > name.size() && entry.starts_with(name) && entry[name.size()] == '=') {
      return entry.substr(name.size() + 1);
    }
  }
  return {};
}

TerminalColours colours_of(const ChafaTermInfo* info) {
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_SET_COLOR_FGBG_DIRECT)) {
    return TerminalColours::true_colour;
  }
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_SET_COLOR_FGBG_256)) {
    return TerminalColours::palette_256;
  }
  return TerminalColours::sixteen;
}

TerminalGraphics graphics_of(const ChafaTermInfo* info) {
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_BEGIN_KITTY_IMMEDIATE_IMAGE_V1)) {
    return TerminalGraphics::kitty;
  }
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_BEGIN_SIXELS)) return TerminalGraphics::sixel;
  return TerminalGraphics::half_blocks;
}

/// Pixels of a character that a picture is drawn with: half blocks are one wide and two high.
struct CharacterSize {
  int width;
  int height;
};

CharacterSize character_size(const Terminal& terminal) {
  if (terminal.graphics == TerminalGraphics::half_blocks) return {1, 2};
  return {std::clamp(terminal.cell_width, 1, kMostPixelsPerCharacter),
          std::clamp(terminal.cell_height, 1, kMostPixelsPerCharacter)};
}

/// The scene on an image of `width` x `height` pixels; what the map does not cover is transparent.
CairoSurface scene_image(const Scene& scene, const MapView& view, int width, int height,
                         const MarkSizes& sizes, const Style& style) {
  CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  const CairoContext context(cairo_create(surface.get()));
  cairo_rectangle(context.get(), view.left, view.top, view.width, view.height);
  cairo_clip(context.get());
  const CairoSurface map =
      image_of(map_image(CellPaints(scene, style), view.width, view.height, view.y_up));
  cairo_set_source_surface(context.get(), map.get(), view.left, view.top);
  cairo_paint(context.get());
  if (scene.arrows && sizes.halo > 0) {  // half blocks have no room for arrows
    draw_arrows(context.get(), *scene.arrows, view, false, style);
  }
  draw_path(context.get(), scene, view, sizes, style);
  if (sizes.halo > 0) {
    draw_sparse_cells(context.get(), scene, view, style);
  } else {
    draw_sparse_pixels(context.get(), scene, view, style);
  }
  draw_marks(context.get(), scene, view, sizes, style);
  cairo_surface_flush(surface.get());
  return surface;
}

/// Every pixel as many, so that chafa need not scale (it would blur).
CairoSurface enlarged(cairo_surface_t* image, int across, int down) {
  const int width = cairo_image_surface_get_width(image) * across;
  const int height = cairo_image_surface_get_height(image) * down;
  CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
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
  switch (terminal.colours) {
    case TerminalColours::none:
      break;
    case TerminalColours::sixteen:
      return CHAFA_CANVAS_MODE_INDEXED_16;
    case TerminalColours::palette_256:
      return CHAFA_CANVAS_MODE_INDEXED_240;  // the 16 others are the user's own
    case TerminalColours::true_colour:
      return CHAFA_CANVAS_MODE_TRUECOLOR;
  }
  return CHAFA_CANVAS_MODE_FGBG;
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
  if (terminal.graphics == TerminalGraphics::half_blocks) {
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

}  // namespace

Terminal detect_terminal(const char* const* environment) {
  const std::string_view term = variable(environment, "TERM");
  if (term.empty() || term == "dumb") return {.unicode = false};
  if (!variable(environment, "NO_COLOR").empty()) return {};
  // Chafa copies what it reads, but its type is that of C's environ.
  const Owned<ChafaTermInfo> info(
      chafa_term_db_detect(chafa_term_db_get_default(), const_cast<gchar**>(environment)));
  Terminal terminal;
  terminal.graphics = graphics_of(info.get());
  terminal.colours = colours_of(info.get());
  return terminal;
}

Style suited(const Scene& scene, const Style& style, TerminalColours colours) {
  Style shown = style_for(scene, style);
  if (colours == TerminalColours::sixteen) {
    shown.path = colour_from(0x0000FF);
    shown.start = colour_from(0x00A000);
    shown.goal = colour_from(0xFF0000);
    shown.lines = {.planned = colour_from(0xE00000),
                   .smoothed = colour_from(0x00A000),
                   .driven = colour_from(0x0000FF)};
  }
  return shown;
}

std::string terminal_shortage(const Scene& scene, int columns, int rows, const Terminal& terminal) {
  columns = std::clamp(columns, 1, kMostCharacters);
  rows = std::clamp(rows, 1, kMostCharacters);
  const bool ascii =
      terminal.graphics == TerminalGraphics::ascii || terminal.colours == TerminalColours::none;
  const CharacterSize character = ascii ? CharacterSize{1, 2} : character_size(terminal);
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
  if (terminal.graphics == TerminalGraphics::ascii || terminal.colours == TerminalColours::none) {
    return ascii_picture(scene, columns, rows);
  }
  const CharacterSize character = character_size(terminal);
  const bool blocks = terminal.graphics == TerminalGraphics::half_blocks;
  const MapView view = fitted_view(scene.space.map(), columns * character.width,
                                   rows * character.height, blocks ? 1 : 3);
  const int used_columns = (view.width + character.width - 1) / character.width;
  const int used_rows = (view.height + character.height - 1) / character.height;
  const MarkSizes sizes =
      blocks ? MarkSizes{.line = 1.5, .halo = 0, .mark = 1} : mark_sizes(scene, view);
  CairoSurface image =
      scene_image(scene, view, used_columns * character.width, used_rows * character.height, sizes,
                  suited(scene, style, terminal.colours));
  if (blocks) image = enlarged(image.get(), kSymbolPixels, kSymbolPixels / 2);
  return printed(image.get(), canvas_config(used_columns, used_rows, terminal).get());
}

}  // namespace wend
