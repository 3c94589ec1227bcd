#include "frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "text_blocks.hpp"

namespace wend::cli {
namespace {

constexpr int kFewestFrameRows = 6;  // of a picture that still shows something
constexpr int kTitleRows = 1;

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
  return names.empty() ? "" : fmt::format("a larger terminal has room for: {}\n", names);
}

/// As text, with so many of the layers; nothing where that is too wide or too high.
std::optional<std::string> as_text(const Scene& scene, const std::vector<Layer>& layers,
                                   std::size_t shown, const Screen& screen, StyleName style,
                                   int rows) {
  if (!is_small(scene, screen)) return std::nullopt;
  const SmallPicture small = small_picture(scene, screen);
  std::vector<std::string> blocks{small.map};
  for (std::size_t i = 0; i < shown; ++i) {
    auto grid = layer_grid(without_marks(scene), layers[i], screen, style);
    if (!grid) return std::nullopt;
    blocks.push_back(*std::move(grid));
  }
  std::string text = side_by_side(blocks, screen.columns) + small.legend + left_out(layers, shown);
  if (rows_of(text) > rows) return std::nullopt;
  return text;
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
    text += std::string(title_of(layers[i].kind)) + "\n";
    text += large_picture(with_layer(without_marks(scene), layers[i]), screen, always,
                          each - kTitleRows);
  }
  return text + note;
}

}  // namespace

std::string frame_text(const Scene& scene, const std::vector<Layer>& layers, const Screen& screen,
                       StyleName style, int rows_below) {
  if (!screen.is_terminal) {
    const PictureArguments always{PictureWhen::always, style};
    std::string text = picture(scene, screen, always);
    for (const Layer& layer : layers) {
      text += layer_text(without_marks(scene), layer, screen, always);
    }
    return text;
  }
  const int rows = screen.rows - rows_below;
  // Better some of the layers in numbers than all of them as pictures.
  const std::size_t fewest = std::min<std::size_t>(layers.size(), 1);
  for (std::size_t shown = layers.size() + 1; shown-- > fewest;) {
    if (auto text = as_text(scene, layers, shown, screen, style, rows)) return *std::move(text);
  }
  return as_pictures(scene, layers, screen, style, rows);
}

}  // namespace wend::cli
