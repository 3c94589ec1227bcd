#include "wend/io/image_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "wend/io/drawn_row.hpp"

namespace wend {
namespace {

struct PixelMeaning {
  CellState state = CellState::unknown;
  double terrain = 1;
};

constexpr int kOccupied = 100;

PixelMeaning raw_meaning(double shade, double scale_factor) {
  const int v = static_cast<int>(std::lround(shade * 255));
  if (v > kOccupied) return {CellState::unknown};
  if (v == kOccupied) return {CellState::occupied};
  return {CellState::free, scaled_terrain(scale_factor, v)};
}

PixelMeaning meaning_of(int value, int maximum, const ImageMeaning& meaning) {
  const double shade = static_cast<double>(value) / maximum;
  if (meaning.mode == ImageMode::raw) return raw_meaning(shade, meaning.scale_factor);
  // One division, so that p is the double nearest to the true fraction.
  const double p = meaning.negate ? shade : static_cast<double>(maximum - value) / maximum;
  if (p <= meaning.free_threshold) return {CellState::free};
  if (p >= meaning.occupied_threshold) return {CellState::occupied};
  if (meaning.mode == ImageMode::trinary) return {CellState::unknown};
  const double between =
      (p - meaning.free_threshold) / (meaning.occupied_threshold - meaning.free_threshold);
  const int v = static_cast<int>(std::lround(100 * between));
  return {CellState::free, scaled_terrain(meaning.scale_factor, v)};
}

std::vector<PixelMeaning> make_table(int maximum, const ImageMeaning& meaning) {
  std::vector<PixelMeaning> table;
  table.reserve(static_cast<std::size_t>(maximum) + 1);
  for (int value = 0; value <= maximum; ++value) {
    table.push_back(meaning_of(value, maximum, meaning));
  }
  return table;
}

/// An image of the map's size, each value as `value_of(cell)` says.
template <class ValueOf>
GreyImage image_of(const GridMap& map, const ValueOf& value_of) {
  GreyImage image;
  image.width = map.width();
  image.height = map.height();
  image.values.reserve(map.size());
  for (int from_top = 0; from_top < map.height(); ++from_top) {
    const int y = drawn_row(from_top, map.height(), map.frame().y_up);
    for (int x = 0; x < map.width(); ++x) image.values.push_back(value_of(Cell{x, y}));
  }
  return image;
}

/// The grey value that kScaleMeaning reads as this terrain; nothing if there is none.
std::optional<std::uint16_t> scale_value(double terrain) {
  const int v = nearest_scale_value(terrain);
  if (scaled_terrain(kScaleMeaning.scale_factor, v) != terrain) return std::nullopt;
  // 0 is occupied by its threshold; 1 is the darkest free value, and rounds to v = 100.
  return static_cast<std::uint16_t>(std::max(1.0, 255 - std::round(2.55 * v)));
}

}  // namespace

GridMap map_from_image(const GreyImage& image, const ImageMeaning& meaning, const Frame& frame) {
  const std::vector<PixelMeaning> table = make_table(image.maximum, meaning);
  const bool has_terrain = meaning.mode != ImageMode::trinary;
  const bool has_alpha = !image.transparent.empty() && meaning.mode != ImageMode::raw;
  Grid<CellState> cells(image.width, image.height);
  Grid<double> terrain = has_terrain ? Grid<double>(image.width, image.height, 1) : Grid<double>();
  for (int y = 0; y < image.height; ++y) {
    const int image_y = drawn_row(y, image.height, frame.y_up);
    const auto values = image.row(image_y);
    const auto states = cells.row(y);
    for (std::size_t x = 0; x < values.size(); ++x) states[x] = table[values[x]].state;
    if (has_terrain) {
      const auto multipliers = terrain.row(y);
      for (std::size_t x = 0; x < values.size(); ++x) multipliers[x] = table[values[x]].terrain;
    }
    if (has_alpha) {
      const auto transparent = image.transparent_row(image_y);
      for (std::size_t x = 0; x < values.size(); ++x) {
        if (transparent[x] == 0) continue;
        states[x] = CellState::unknown;
        if (has_terrain) terrain[{static_cast<int>(x), y}] = 1;
      }
    }
  }
  return GridMap(cells, frame, std::move(terrain));
}

Expected<GreyImage, std::string> trinary_image(const GridMap& map) {
  if (!map.uniform_terrain()) {
    return Unexpected<std::string>("a picture of free and occupied cells cannot hold terrain");
  }
  return image_of(map, [&](Cell cell) -> std::uint16_t {
    if (map.occupied()[cell]) return 0;
    return map.unknown()[cell] ? 205 : 254;
  });
}

int nearest_scale_value(double terrain) {
  const double v = std::round((terrain - 1) * 100 / kScaleMeaning.scale_factor);
  return static_cast<int>(std::clamp(v, 0.0, 100.0));
}

Expected<GreyImage, std::string> scale_image(const GridMap& map) {
  std::string wrong;
  bool any_transparent = false;
  std::vector<unsigned char> transparent;
  transparent.reserve(map.size());
  GreyImage image = image_of(map, [&](Cell cell) -> std::uint16_t {
    const CellState state = map.state(cell);
    transparent.push_back(state == CellState::unknown ? 1 : 0);
    any_transparent = any_transparent || state == CellState::unknown;
    if (state == CellState::occupied) return 0;
    const auto value = scale_value(map.terrain(cell));
    if (!value || (state == CellState::unknown && map.terrain(cell) != 1)) {
      wrong = fmt::format(
          "a scale map cannot hold the terrain {} of cell ({},{}), only 1 + 4 v/100 of free "
          "cells, v = 0..100",
          map.terrain(cell), cell.x, cell.y);
    }
    return value.value_or(0);
  });
  if (!wrong.empty()) return Unexpected<std::string>(wrong);
  if (any_transparent) image.transparent = std::move(transparent);
  return image;
}

}  // namespace wend
