#include "wend/io/image_map.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

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

}  // namespace

GridMap map_from_image(const GreyImage& image, const ImageMeaning& meaning, const Frame& frame) {
  const std::vector<PixelMeaning> table = make_table(image.maximum, meaning);
  const bool has_terrain = meaning.mode != ImageMode::trinary;
  const bool has_alpha = !image.transparent.empty() && meaning.mode != ImageMode::raw;
  Grid<CellState> cells(image.width, image.height);
  Grid<double> terrain = has_terrain ? Grid<double>(image.width, image.height, 1) : Grid<double>();
  for (int y = 0; y < image.height; ++y) {
    const int image_y = frame.y_up ? image.height - 1 - y : y;
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

}  // namespace wend
