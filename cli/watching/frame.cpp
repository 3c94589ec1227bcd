#include "cli/watching/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "cli/output/terminal.hpp"

namespace wend::cli {
namespace {

constexpr int kFewestFrameRows = 6;  // of a picture that still shows something
constexpr int kFewestPictureRows = 2;
constexpr double kLargeCell = 4;    // half characters: larger than a cell as text
constexpr int kFewestColumns = 30;  // of a picture that still shows something
constexpr std::array<int, 4> kRowsBeside{15, 12, 9, 6};  // the first of them that there is room for

int rows_of(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

Scene without_marks(Scene scene) {
  scene.marked.clear();
  return scene;
}

/// Says which layers there is no room for.
std::string left_out(const std::vector<Layer>& layers, std::size_t shown) {
  std::string names;
  for (std::size_t i = shown; i < layers.size(); ++i) {
    names += (names.empty() ? "" : ", ") + std::string(choice_name(layers[i].kind));
  }
  return names.empty() ? "" : fmt::format("shown on a larger terminal: {}\n", names);
}

/// The map, its first layers and the text beside it; nothing if that is too wide or too high.
std::optional<std::string> as_text(const Scene& scene, const std::vector<Layer>& layers,
                                   std::size_t shown, const std::string& beside,
                                   const Screen& screen, StyleName style, int rows) {
  if (!is_small(scene, screen)) return std::nullopt;
  const SmallPicture small = small_picture(scene, screen);
  std::vector<std::string> blocks{small.map};
  if (!beside.empty()) blocks.push_back(beside);
  for (std::size_t i = 0; i < shown; ++i) {
    auto grid = layer_grid(without_marks(scene), layers[i], screen, style);
    if (!grid) return std::nullopt;
    blocks.push_back(*std::move(grid));
  }
  std::string text = side_by_side(blocks, screen.columns) + small.legend + left_out(layers, shown);
  if (rows_of(text) > rows) return std::nullopt;
  return text;
}

/// As text, with as many of the layers and as many rows beside the map as there is room for.
std::optional<std::string> as_text(const Scene& scene, const std::vector<Layer>& layers,
                                   const Screen& screen, StyleName style, int rows,
                                   const BesideMap& beside) {
  // Better some of the layers in numbers than all of them as pictures.
  const std::size_t fewest = std::min<std::size_t>(layers.size(), 1);
  for (std::size_t shown = layers.size() + 1; shown-- > fewest;) {
    for (const int rows_beside : kRowsBeside) {
      const std::string block = beside ? beside(rows_beside) : "";
      if (auto text = as_text(scene, layers, shown, block, screen, style, rows)) return text;
      if (!beside) break;
    }
  }
  return std::nullopt;
}

/// What is drawn for one layer, or for the map.
struct ShownPicture {
  std::string title;  // a line, or empty
  Scene scene;
};

std::vector<ShownPicture> pictures_of(const Scene& scene, const std::vector<Layer>& layers) {
  std::vector<ShownPicture> pictures{{{}, scene}};
  for (const Layer& layer : layers) {
    Scene shown = with_layer(without_marks(scene), layer);
    // The legend has the title of a heatmap.
    const std::string title = layer_title(layer.kind, scene.space.map().frame()) + "\n";
    pictures.push_back({shown.heatmap ? "" : title, std::move(shown)});
  }
  return pictures;
}

std::string text_below(const ShownPicture& picture, const Screen& screen, StyleName style) {
  return terminal_legend(picture.scene, screen.columns, screen.terminal, style_of(style));
}

/// A title, the picture and its legend.
std::string drawn(const ShownPicture& picture, const Screen& screen, StyleName style, int rows) {
  const std::string legend = text_below(picture, screen, style);
  const int room = std::max(rows - rows_of(picture.title + legend), kFewestPictureRows);
  return picture.title +
         terminal_picture(picture.scene, screen.columns, room, screen.terminal, style_of(style)) +
         legend;
}

/// How large a cell is drawn in that room: in half characters, or in the like of them.
double cell_size(const ShownPicture& picture, const Screen& screen, StyleName style, int rows) {
  const int room = rows - rows_of(picture.title + text_below(picture, screen, style));
  const double size =
      std::min(static_cast<double>(screen.columns) / picture.scene.space.width(),
               2.0 * std::max(room, kFewestPictureRows) / picture.scene.space.height());
  return size < 1 ? size : std::floor(size);
}

/// Some of the pictures, so many beside each other.
struct Arrangement {
  std::size_t shown = 1;
  int across = 1;
  double cell = 0;  // its size

  int rows_each(int rows) const { return rows / ((static_cast<int>(shown) + across - 1) / across); }

  Screen screen_each(Screen screen) const {
    screen.columns = (screen.columns - (across - 1) * kGapBetweenBlocks) / across;
    return screen;
  }
};

/// The arrangement with the largest cells of as many pictures as there is room for. Pixels leave no room beside them.
Arrangement arranged(const std::vector<ShownPicture>& pictures, const Screen& screen,
                     StyleName style, int rows) {
  for (std::size_t shown = pictures.size(); shown > 0; --shown) {
    Arrangement best{shown};
    const int widest = has_pixels(screen.terminal) ? 1 : static_cast<int>(shown);
    for (int across = 1; across <= widest; ++across) {
      Arrangement tried{shown, across};
      const Screen each = tried.screen_each(screen);
      if (shown > 1 && tried.rows_each(rows) < kFewestFrameRows) continue;
      if (across > 1 && each.columns < kFewestColumns) continue;
      tried.cell = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < shown; ++i) {
        const bool narrow = columns_of_all(text_below(pictures[i], each, style)) <= each.columns;
        if (across > 1 && !narrow) tried.cell = 0;
        tried.cell =
            std::min(tried.cell, cell_size(pictures[i], each, style, tried.rows_each(rows)));
      }
      if (tried.cell > best.cell) best = tried;
    }
    if (best.cell > 0) return best;
  }
  return {};
}

/// All of it as pictures, in at most that many rows unless there are very few.
std::string as_pictures(const Scene& scene, const std::vector<Layer>& layers, const Screen& screen,
                        StyleName style, int rows) {
  const std::vector<ShownPicture> pictures = pictures_of(scene, layers);
  Arrangement way = arranged(pictures, screen, style, rows);
  if (way.shown < pictures.size()) way = arranged(pictures, screen, style, --rows);  // for the note
  const Screen each = way.screen_each(screen);
  std::vector<std::string> blocks;
  blocks.reserve(way.shown);
  for (std::size_t i = 0; i < way.shown; ++i) {
    blocks.push_back(drawn(pictures[i], each, style, way.rows_each(rows)));
  }
  const std::string note = left_out(layers, way.shown - 1);
  if (way.across > 1) return side_by_side(blocks, screen.columns) + note;
  std::string text;
  for (const std::string& block : blocks) text += block;
  return text + note;
}

/// The same with what stands beside the map, or below it if cells are larger then.
std::string as_pictures(const Scene& scene, const std::vector<Layer>& layers, const Screen& screen,
                        StyleName style, int rows, const BesideMap& beside) {
  const std::vector<ShownPicture> pictures = pictures_of(scene, layers);
  const std::string below = beside(std::max(kRowsBeside.back(), rows / 3));
  const int rows_above = rows - rows_of(below);
  const std::string block = beside(rows);
  Screen narrower = screen;
  narrower.columns = screen.columns - columns_of_all(block) - kGapBetweenBlocks;
  if (narrower.columns >= kFewestColumns && !has_pixels(screen.terminal)) {
    const Arrangement narrow = arranged(pictures, narrower, style, rows);
    const Arrangement wide = arranged(pictures, screen, style, rows_above);
    if (narrow.shown >= wide.shown && narrow.cell >= wide.cell) {
      return side_by_side({as_pictures(scene, layers, narrower, style, rows), block},
                          screen.columns);
    }
  }
  return as_pictures(scene, layers, screen, style, rows_above) + below;
}

/// Where there is room for everything.
std::string as_long_text(const Scene& scene, const std::vector<Layer>& layers, const Screen& screen,
                         StyleName style, const BesideMap& beside) {
  const PictureArguments always{PictureWhen::always, style};
  std::string text = picture(scene, screen, always);
  if (beside) text += beside(kRowsBeside.front());
  for (const Layer& layer : layers) {
    text += layer_text(without_marks(scene), layer, screen, always);
  }
  return text;
}

}  // namespace

std::string frame_text(const Scene& scene, const std::vector<Layer>& layers, const Screen& screen,
                       StyleName style, int rows_below, const BesideMap& beside) {
  if (!screen.is_terminal) return as_long_text(scene, layers, screen, style, beside);
  const int rows = screen.rows - rows_below;
  const bool enlarged =
      layers.empty() && !screen.terminal.plain() &&
      arranged(pictures_of(scene, {}), screen, style, rows / 2).cell >= kLargeCell;
  if (!enlarged) {
    if (auto text = as_text(scene, layers, screen, style, rows, beside)) return *std::move(text);
  }
  return beside ? as_pictures(scene, layers, screen, style, rows, beside)
                : as_pictures(scene, layers, screen, style, rows);
}

}  // namespace wend::cli
