#include "wend/io/map/image_map.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "wend/io/map/doubts.hpp"
#include "wend/io/map/map_format.hpp"

namespace wend {
namespace {

constexpr int kOccupied = 100;

/// The value v whose terrain is nearest to this one, with kScaleMeaning.
int nearest_scale_value(double terrain) {
  const double v = std::round((terrain - 1) * 100 / kScaleMeaning.scale_factor);
  return static_cast<int>(std::clamp(v, 0.0, 100.0));
}

/// The grey value that kScaleMeaning reads as v. By its threshold 0 is occupied; 1 is the darkest free
/// value and rounds to v = 100.
std::uint16_t grey_of(int v) {
  return static_cast<std::uint16_t>(std::max(1.0, 255 - std::round(2.55 * v)));
}

/// An image of the map's size, with `value_of(cell)` for each pixel.
template <class ValueOf>
GreyImage image_of(const GridMap& map, const ValueOf& value_of) {
  GreyImage image;
  image.width = map.width();
  image.height = map.height();
  image.values.reserve(map.size());
  for (const int y : rows_from_top(map)) {
    for (int x = 0; x < map.width(); ++x) image.values.push_back(value_of(Cell{x, y}));
  }
  return image;
}

Expected<LoadedMap, Error> load_bare_image(const std::string& bytes, const MapSource& source,
                                           const LoadOptions& options) {
  ImageMapRows rows({});
  auto notes = decode_image(bytes, rows);
  if (!notes) return file_failure(source.file, 0, notes.error().message);
  const Frame frame{.resolution = options.resolution.value_or(1),
                    .metric = options.resolution.has_value()};
  auto map = rows.finish(frame);
  if (!map) return file_failure(source.file, 0, map.error().message);
  for (std::string& doubt : doubts_about(rows, {}, *map)) notes->push_back(std::move(doubt));
  return LoadedMap{*std::move(map), MapFormat::image_map, *std::move(notes)};
}

Expected<MapFiles, Error> save_bare_image(const GridMap& map, const std::filesystem::path& file) {
  const GreyImage image = trinary_image(map);
  if (lower_case(file.extension().string()) != ".png") return MapFiles{encode_pgm(image)};
  return encode_png(image).map([](std::string bytes) { return MapFiles{std::move(bytes)}; });
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
  greys_.maximum = maximum;
  for (int value = 0; value <= maximum; ++value) {
    table_.push_back(meaning_of(value, maximum));
    state_table_.push_back(table_.back().state);
  }
  rows_.emplace(width);
  states_.resize(static_cast<std::size_t>(width));
  if (meaning_.mode != ImageMode::trinary) terrain_.resize(states_.size());
}

void ImageMapRows::look_at(std::span<const std::uint16_t> values) {
  // No value is above 65535, so this one stands for a grey that the image cannot have.
  const bool has_grey = greys_.maximum % 255 == 0;
  const int grey = has_grey ? kSavedUnknown * (greys_.maximum / 255) : 65536;
  int darkest = greys_.darkest;
  int brightest = greys_.brightest;
  std::size_t count = 0;
  for (const int value : values) {
    darkest = std::min(darkest, value);
    brightest = std::max(brightest, value);
    count += value == grey ? 1U : 0U;
  }
  greys_.darkest = darkest;
  greys_.brightest = brightest;
  greys_.saved_unknown += count;
}

void ImageMapRows::add(std::span<const std::uint16_t> values,
                       std::span<const unsigned char> transparent) {
  const std::span<CellState> states = states_;
  const std::span<const CellState> state_table = state_table_;
  for (std::size_t x = 0; x < values.size(); ++x) states[x] = state_table[values[x]];
  for (std::size_t x = 0; x < terrain_.size(); ++x) terrain_[x] = table_[values[x]].terrain;
  if (meaning_.mode != ImageMode::raw) {
    for (std::size_t x = 0; x < transparent.size(); ++x) {
      if (transparent[x] == 0) continue;
      states_[x] = CellState::unknown;
      if (!terrain_.empty()) terrain_[x] = 1;
    }
  }
  look_at(values);
  assert(rows_);  // begin() comes first
  rows_->append(states_, terrain_);
}

GreyImage trinary_image(const GridMap& map) {
  return image_of(map, [&](Cell cell) -> std::uint16_t {
    if (map.occupied()[cell]) return 0;
    return map.unknown()[cell] ? kSavedUnknown : 254;
  });
}

double nearest_scaled_terrain(double terrain) {
  return scaled_terrain(kScaleMeaning.scale_factor, nearest_scale_value(terrain));
}

GreyImage scale_image(const GridMap& map) {
  std::vector<unsigned char> transparent;
  transparent.reserve(map.size());
  GreyImage image = image_of(map, [&](Cell cell) -> std::uint16_t {
    const CellState state = map.state(cell);
    transparent.push_back(state == CellState::unknown ? 1 : 0);
    return state == CellState::occupied ? 0 : grey_of(nearest_scale_value(map.terrain(cell)));
  });
  if (map.unknown().count() > 0) image.transparent = std::move(transparent);
  return image;
}

MapFormatInfo image_map_format() {
  return {.format = MapFormat::image_map,
          .name = "image",
          .noun = "an image",
          .extensions = {".png", ".pgm", ".pbm", ".ppm", ".pnm", ".bmp", ".jpg", ".jpeg"},
          .saved_extensions = {".png", ".pgm", ".pnm"},
          .recognises = looks_like_image,
          .load_bytes = load_bare_image,
          .takes_resolution = true,
          .save = save_bare_image};
}

}  // namespace wend
