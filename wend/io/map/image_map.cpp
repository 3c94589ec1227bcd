#include "wend/io/map/image_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "wend/io/map/drawn_row.hpp"

namespace wend {
namespace {

constexpr int kOccupied = 100;

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

ImageMapRows::PixelMeaning ImageMapRows::raw_meaning(double shade, double scale_factor) {
  const int v = static_cast<int>(std::lround(shade * 255));
  if (v > kOccupied) return {CellState::unknown};
  if (v == kOccupied) return {CellState::occupied};
  return {CellState::free, scaled_terrain(scale_factor, v)};
}

ImageMapRows::PixelMeaning ImageMapRows::meaning_of(int value, int maximum) const {
  const double shade = static_cast<double>(value) / maximum;
  if (meaning_.mode == ImageMode::raw) return raw_meaning(shade, meaning_.scale_factor);
  // One division, so that p is the double nearest to the true fraction.
  const double p = meaning_.negate ? shade : static_cast<double>(maximum - value) / maximum;
  if (p <= meaning_.free_threshold) return {CellState::free};
  if (p >= meaning_.occupied_threshold) return {CellState::occupied};
  if (meaning_.mode == ImageMode::trinary) return {CellState::unknown};
  const double between =
      (p - meaning_.free_threshold) / (meaning_.occupied_threshold - meaning_.free_threshold);
  const int v = static_cast<int>(std::lround(100 * between));
  return {CellState::free, scaled_terrain(meaning_.scale_factor, v)};
}

void ImageMapRows::begin(int width, int /*height*/, int maximum) {
  for (int value = 0; value <= maximum; ++value) table_.push_back(meaning_of(value, maximum));
  rows_.emplace(width);
  states_.resize(static_cast<std::size_t>(width));
  if (meaning_.mode != ImageMode::trinary) terrain_.resize(states_.size());
}

void ImageMapRows::add(std::span<const std::uint16_t> values,
                       std::span<const unsigned char> transparent) {
  for (std::size_t x = 0; x < values.size(); ++x) states_[x] = table_[values[x]].state;
  for (std::size_t x = 0; x < terrain_.size(); ++x) terrain_[x] = table_[values[x]].terrain;
  if (meaning_.mode != ImageMode::raw) {
    for (std::size_t x = 0; x < transparent.size(); ++x) {
      if (transparent[x] == 0) continue;
      states_[x] = CellState::unknown;
      if (!terrain_.empty()) terrain_[x] = 1;
    }
  }
  assert(rows_);  // begin() comes first
  rows_->append(states_, terrain_);
}

GridMap map_from_image(const GreyImage& image, const ImageMeaning& meaning, const Frame& frame) {
  ImageMapRows rows(meaning);
  rows.begin(image.width, image.height, image.maximum);
  for (int y = 0; y < image.height; ++y) {
    rows.add(image.row(y), image.transparent.empty() ? std::span<const unsigned char>()
                                                     : image.transparent_row(y));
  }
  return rows.finish(frame);
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
