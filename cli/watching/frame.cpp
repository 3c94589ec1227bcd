#include "cli/watching/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "cli/output/terminal.hpp"

namespace wend::cli {
namespace {

constexpr int kFewestFrameRows = 6;  // of a picture that still shows something
constexpr int kTitleRows = 1;
constexpr int kFewestColumns = 30;                       // of a picture that still shows something
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

/// As pictures below each other, as many as there is room for.
std::string as_pictures(const Scene& scene, const std::vector<Layer>& layers, const Screen& screen,
                        StyleName style, int rows) {
  const PictureArguments always{PictureWhen::always, style};
  const auto room = static_cast<std::size_t>(std::max(1, rows / kFewestFrameRows));
  const std::size_t shown = std::min(layers.size(), room - 1);
  const std::string note = left_out(layers, shown);
  const int each = (rows - rows_of(note)) / (static_cast<int>(shown) + 1);
  std::string text = large_picture(scene, screen, always, each);
  for (std::size_t i = 0; i < shown; ++i) {
    text += layer_title(layers[i].kind, scene.space.map().frame()) + "\n";
    text += large_picture(with_layer(without_marks(scene), layers[i]), screen, always,
                          each - kTitleRows);
  }
  return text + note;
}

/// The same with what stands beside the map. Pixels leave no room beside them.
std::string as_pictures(const Scene& scene, const std::vector<Layer>& layers, const Screen& screen,
                        StyleName style, int rows, const BesideMap& beside) {
  const std::string block = beside(rows);
  const int columns = screen.columns - columns_of_all(block) - kGapBetweenBlocks;
  if (columns >= kFewestColumns && !has_pixels(screen.terminal)) {
    Screen narrower = screen;
    narrower.columns = columns;
    const std::string pictures = as_pictures(scene, layers, narrower, style, rows);
    // An entry of a legend may be wider.
    if (columns_of_all(pictures) <= columns) {
      return side_by_side({pictures, block}, screen.columns);
    }
  }
  const std::string below = beside(rows - kFewestFrameRows);
  return as_pictures(scene, layers, screen, style, rows - rows_of(below)) + below;
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
  if (auto text = as_text(scene, layers, screen, style, rows, beside)) return *std::move(text);
  return beside ? as_pictures(scene, layers, screen, style, rows, beside)
                : as_pictures(scene, layers, screen, style, rows);
}

}  // namespace wend::cli
